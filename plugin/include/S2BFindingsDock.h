// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BDock.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

//! "Scan to BIM: findings": the diagnostics of a model; a click takes the camera there
class S2BFindingsDock : public S2BDock
{
	Q_OBJECT

  public:
	explicit S2BFindingsDock(ccMainAppInterface& app);

  protected:
	void fill() override;

  private:
	void go(QTreeWidgetItem* item);

	QLabel*      m_title = nullptr;
	QTreeWidget* m_list  = nullptr;
};
