// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ccPickingListener.h>
#include <functional>

class ccMainAppInterface;

//! Hands on the points that the user picks in the 3D view, in world coordinates
class S2BPicker : public ccPickingListener
{
  public:
	explicit S2BPicker(ccMainAppInterface& app);
	~S2BPicker() override;

	//! Starts picking; false when another tool of CloudCompare picks already
	bool start(const std::function<void(const CCVector3d&)>& onPoint);
	void stop();
	bool isActive() const
	{
		return static_cast<bool>(m_onPoint);
	}

	void onItemPicked(const PickedItem& item) override;

  private:
	ccMainAppInterface&                    m_app;
	std::function<void(const CCVector3d&)> m_onPoint;
};
