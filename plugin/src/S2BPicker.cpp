// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BPicker.h"

#include <ccHObjectCaster.h>
#include <ccMainAppInterface.h>
#include <ccPickingHub.h>
#include <ccShiftedObject.h>

S2BPicker::S2BPicker(ccMainAppInterface& app)
    : m_app(app)
{
}

S2BPicker::~S2BPicker()
{
	stop();
}

bool S2BPicker::start(const std::function<void(const CCVector3d&)>& onPoint)
{
	stop();
	if (!m_app.pickingHub() || !m_app.pickingHub()->addListener(this, true))
		return false;
	m_onPoint = onPoint;
	return true;
}

void S2BPicker::stop()
{
	if (m_onPoint && m_app.pickingHub())
		m_app.pickingHub()->removeListener(this);
	m_onPoint = {};
}

void S2BPicker::onItemPicked(const PickedItem& item)
{
	const ccShiftedObject* shifted = item.entity ? ccHObjectCaster::ToShifted(item.entity) : nullptr;
	if (!m_onPoint || !shifted)
		return;
	const auto onPoint = m_onPoint; // it may end the picking
	onPoint(shifted->toGlobal3d(item.P3D));
}
