// SPDX-License-Identifier: GPL-3.0-or-later
#include "qScanToBim.h"

#include "S2BActions.h"
#include "S2BCommand.h"
#include "S2BEditPanel.h"
#include "S2BFindings.h"
#include "S2BFindingsDock.h"
#include "S2BFloorPlan.h"
#include "S2BHelp.h"
#include "S2BTreeUpdate.h"
#include "S2BValidationDock.h"
#include "S2BValidationTree.h"
#include "S2BView.h"

#include <QAction>
#include <QMainWindow>
#include <QTimer>
#include <ccMainAppInterface.h>

namespace
{
	//! One entry of the menu and button of the toolbar
	struct ActionInfo
	{
		const char* name; //!< object name, "S2B." before it
		const char* icon; //!< images/<icon>.png
		const char* text;
		const char* toolTip;
		void (*trigger)(ccMainAppInterface&);
		bool (*fits)(const ccHObject::Container&); //!< whether it can do something with the selection
	};

	bool always(const ccHObject::Container&)
	{
		return true;
	}

	void showFindings(ccMainAppInterface& app)
	{
		auto* dock = S2BDock::of<S2BFindingsDock>(app);
		if (const ccHObject* model = s2b::modelOf(app.getSelectedEntities()))
			dock->setSubject(model);
		dock->present();
	}

	void showValidation(ccMainAppInterface& app)
	{
		auto* dock = S2BDock::of<S2BValidationDock>(app);
		if (const ccHObject* validation = s2b::validationOf(app.getSelectedEntities()))
			dock->setSubject(validation);
		dock->present();
	}

	// The last ones of the menu, in its order.
	const std::vector<ActionInfo> kTools{
	    {"Findings", "findings", "Findings", "The list of what was uncertain in the selected model: a click takes the camera there", showFindings, always},
	    {"ValidationTable", "validation_table", "Validation table", "The list of a validation's elements with their errors: a click selects and zooms", showValidation, always},
	    {"FloorPlan", "floor_plan", "Floor plan", "The selected storey from above, cut 1.2 m above its floor; once more goes back", s2b::toggleFloorPlan, s2b::canToggleFloorPlan},
	    {"Help", "help", "Help", "From scan to IFC in ten minutes, every parameter, conventions and limits", s2b::showHelp, always},
	};
} // namespace

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
	if (m_tools.isEmpty())
		m_tools = makeTools();
	return QList<QAction*>{m_reconstruct, m_segment} + m_stages + QList<QAction*>{m_edit, m_translucent, m_exportIfc, m_validate} + m_tools;
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

QList<QAction*> qScanToBim::makeTools()
{
	QList<QAction*> actions;
	for (const ActionInfo& info : kTools)
	{
		auto* action = new QAction(QIcon(QString(":/CC/plugin/qScanToBim/images/%1.png").arg(info.icon)), tr(info.text), this);
		action->setObjectName(QString("S2B.") + info.name);
		action->setToolTip(tr(info.toolTip));
		action->setEnabled(info.fits({}));
		connect(action, &QAction::triggered, this, [this, &info]
		        { info.trigger(*m_app); });
		actions << action;
	}
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
	for (int i = 0; i < m_tools.size(); ++i)
		m_tools[i]->setEnabled(kTools[static_cast<std::size_t>(i)].fits(selectedEntities));
	if (!m_app || !m_app->getMainWindow())
		return;
	// The lists follow the selection, and a finding's label takes the camera to it. Not within the signal: CloudCompare is
	// still busy with the selection.
	if (const ccHObject* model = s2b::modelOf(selectedEntities))
		S2BDock::of<S2BFindingsDock>(*m_app)->setSubject(model);
	if (const ccHObject* validation = s2b::validationOf(selectedEntities))
		S2BDock::of<S2BValidationDock>(*m_app)->setSubject(validation);
	if (const ccHObject* label = s2b::findingOf(selectedEntities))
	{
		QTimer::singleShot(0, this, [this, id = label->getUniqueID()]
		                   {
			                   if (ccHObject* finding = s2b::findEntity(*m_app, id))
				                   s2b::showFinding(*m_app, *finding); });
	}
}

void qScanToBim::registerCommands(ccCommandLineInterface* cmd)
{
	if (cmd)
		cmd->registerCommand(ccCommandLineInterface::Command::Shared(new S2BCommand));
}
