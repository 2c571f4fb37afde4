// SPDX-License-Identifier: GPL-3.0-or-later
#include "qScanToBim.h"

#include "S2BActions.h"
#include "S2BCommand.h"

#include <QAction>

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
	return {m_reconstruct, m_segment, m_exportIfc, m_validate};
}

void qScanToBim::onNewSelection(const ccHObject::Container& selectedEntities)
{
	if (m_reconstruct)
		m_reconstruct->setEnabled(!s2b::cloudsOf(selectedEntities).empty());
	if (m_segment)
		m_segment->setEnabled(!s2b::cloudsOf(selectedEntities).empty());
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
