// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <ccStdPluginInterface.h>
#include <vector>

class QAction;
class S2BEditPanel;

//! Plugins > Scan to BIM, and -S2B on the command line
class qScanToBim : public QObject
    , public ccStdPluginInterface
{
	Q_OBJECT
	Q_INTERFACES(ccPluginInterface ccStdPluginInterface)
	Q_PLUGIN_METADATA(IID "cccorp.cloudcompare.plugin.qScanToBim" FILE "../info.json")

  public:
	explicit qScanToBim(QObject* parent = nullptr);
	~qScanToBim() override = default;

	// inherited from ccStdPluginInterface
	void            onNewSelection(const ccHObject::Container& selectedEntities) override;
	QList<QAction*> getActions() override;
	void            registerCommands(ccCommandLineInterface* cmd) override;

  private:
	QAction* m_reconstruct = nullptr;
	QAction* m_segment     = nullptr;
	QAction* m_exportIfc   = nullptr;
	QAction* m_validate    = nullptr;

	//! Those of single stages, and of corrections
	QList<QAction*> makeStageActions();
	QList<QAction*> m_stages;
	QAction*        m_edit        = nullptr;
	QAction*        m_translucent = nullptr;
	S2BEditPanel*   m_editPanel   = nullptr;

	//! Lists, views and help
	QList<QAction*> makeTools();
	QList<QAction*> m_tools;
};
