// SPDX-License-Identifier: GPL-3.0-or-later
#include "qScanToBim.h"

#include "S2BActions.h"
#include "S2BCommand.h"
#include "S2BEditPanel.h"
#include "S2BTreeUpdate.h"

#include <QAction>
#include <QMainWindow>
#include <ccMainAppInterface.h>

qScanToBim::qScanToBim(QObject* parent)
    : QObject(parent)
    , ccStdPluginInterface(":/CC/plugin/qScanToBim/info.json")
{
}

QList<QAction*> qScanToBim::getActions()
{
	if (!m_reconstruct)
	{
		m_reconstruct = new QAction(QIcon(":/CC/plugin/qScanToBim/images/reconstruct.png"), tr("Reconstruct..."), this);
		m_reconstruct->setObjectName("S2B.Reconstruct");
		m_reconstruct->setToolTip(tr("Reconstruct storeys, walls, openings, columns, slabs and spaces from the selected clouds"));
		m_reconstruct->setEnabled(false);
		connect(m_reconstruct, &QAction::triggered, this, [this]
		        { s2b::reconstructSelection(*m_app); });

		m_segment = new QAction(QIcon(":/CC/plugin/qScanToBim/images/segment.png"), tr("Segment..."), this);
		m_segment->setObjectName("S2B.Segment");
		m_segment->setToolTip(tr("Label the points of the selected clouds as floor, ceiling, wall, door, ... with a trained model"));
		m_segment->setEnabled(false);
		connect(m_segment, &QAction::triggered, this, [this]
		        { s2b::segmentSelection(*m_app); });

		m_exportIfc = new QAction(QIcon(":/CC/plugin/qScanToBim/images/export_ifc.png"), tr("Export IFC..."), this);
		m_exportIfc->setObjectName("S2B.ExportIfc");
		m_exportIfc->setToolTip(tr("Write the selected model, without what was deleted from it, as an IFC file"));
		m_exportIfc->setEnabled(false);
		connect(m_exportIfc, &QAction::triggered, this, [this]
		        { s2b::exportSelection(*m_app); });

		m_validate = new QAction(QIcon(":/CC/plugin/qScanToBim/images/validate.png"), tr("Validate against BIM..."), this);
		m_validate->setObjectName("S2B.Validate");
		m_validate->setToolTip(tr("Compare the selected clouds and model with a ground-truth BIM: figures, deviations and a report"));
		m_validate->setEnabled(false);
		connect(m_validate, &QAction::triggered, this, [this]
		        { s2b::validateSelection(*m_app); });
	}
	if (m_stages.isEmpty())
		m_stages = makeStageActions();
	return QList<QAction*>{m_reconstruct, m_segment} + m_stages + QList<QAction*>{m_edit, m_translucent, m_exportIfc, m_validate};
}

QList<QAction*> qScanToBim::makeStageActions()
{
	using s2b::Stage;
	const auto make = [this](const char* name, const char* icon, const QString& text, const QString& toolTip)
	{
		auto* action = new QAction(QIcon(QString(":/CC/plugin/qScanToBim/images/%1.png").arg(icon)), text, this);
		action->setObjectName(name);
		action->setToolTip(toolTip);
		action->setEnabled(false);
		return action;
	};
	const struct
	{
		const char*     name;
		const char*     icon;
		QString         text;
		QString         toolTip;
		std::set<Stage> stages;
	} kinds[] = {
	    {"S2B.Levels", "levels", tr("Levels"), tr("Find the levels alone; corrected ones stay"), {Stage::Levels}},
	    {"S2B.Walls", "walls", tr("Walls"), tr("Find the walls on the levels that are there, of a selected storey only its own; corrected ones stay"), {Stage::Walls}},
	    {"S2B.Doors", "doors", tr("Doors"), tr("Find doors, windows and openings in the walls that are there; corrected ones stay"), {Stage::Doors, Stage::Windows, Stage::Openings}},
	    {"S2B.Columns", "columns", tr("Columns"), tr("Find the columns between the walls that are there; corrected ones stay"), {Stage::Columns}},
	    {"S2B.Rooms", "rooms", tr("Rooms"), tr("Find slabs and spaces between the walls that are there; corrected ones stay"), {Stage::Slabs, Stage::Spaces}},
	};
	QList<QAction*> actions;
	for (const auto& kind : kinds)
	{
		actions << make(kind.name, kind.icon, kind.text, kind.toolTip);
		connect(actions.back(), &QAction::triggered, this, [this, stages = kind.stages]
		        { s2b::runStages(*m_app, stages); });
	}
	m_edit = make("S2B.Edit", "edit", tr("Edit element"), tr("Correct dimensions and classes, merge, split and add walls, reset an element"));
	m_edit->setEnabled(true);
	m_edit->setCheckable(true);
	connect(m_edit, &QAction::toggled, this, [this](bool isOn)
	        {
		        if (!m_editPanel && isOn)
		        {
			        m_editPanel = new S2BEditPanel(*m_app);
			        m_app->getMainWindow()->addDockWidget(Qt::RightDockWidgetArea, m_editPanel);
			        connect(m_editPanel, &QDockWidget::visibilityChanged, m_edit, &QAction::setChecked);
		        }
		        if (m_editPanel)
			        m_editPanel->setVisible(isOn); });
	m_translucent = make("S2B.Translucent", "translucent", tr("Translucent"), tr("Look through the faces of the selected model"));
	m_translucent->setCheckable(true);
	connect(m_translucent, &QAction::triggered, this, [this]
	        { s2b::toggleTranslucent(*m_app); });
	return actions;
}

void qScanToBim::onNewSelection(const ccHObject::Container& selectedEntities)
{
	if (m_reconstruct)
		m_reconstruct->setEnabled(!s2b::cloudsOf(selectedEntities).empty());
	if (m_segment)
		m_segment->setEnabled(!s2b::cloudsOf(selectedEntities).empty());
	for (QAction* action : m_stages)
		action->setEnabled(!s2b::stageSelection(selectedEntities).isEmpty());
	if (m_translucent)
	{
		const ccHObject* model = s2b::modelOf(selectedEntities);
		m_translucent->setEnabled(model != nullptr);
		m_translucent->setChecked(model && s2b::isTranslucent(*model));
	}
	if (m_editPanel)
		m_editPanel->setSelection(selectedEntities);
	if (m_exportIfc)
		m_exportIfc->setEnabled(s2b::modelOf(selectedEntities) != nullptr);
	if (m_validate)
		m_validate->setEnabled(!s2b::validationSelection(selectedEntities).isEmpty());
}

void qScanToBim::registerCommands(ccCommandLineInterface* cmd)
{
	if (cmd)
		cmd->registerCommand(ccCommandLineInterface::Command::Shared(new S2BCommand));
}
