// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialog remembers from one time to the next.
#include "S2BEpsgField.h"
#include "S2BLabelBox.h"
#include "S2BParameterPanel.h"
#include "S2BPresetBar.h"
#include "S2BReconstructDlg.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <ccPointCloud.h>

namespace
{
	const QString kSettings = "qScanToBim";
}

void S2BReconstructDlg::readSettings()
{
	QSettings settings;
	settings.beginGroup(kSettings);
	for (const s2b::ParameterInfo& info : s2b::parameterTable())
	{
		const QString key = "parameters/" + QString::fromStdString(info.name);
		if (!settings.contains(key))
			continue;
		try
		{
			info.set(m_parameters, settings.value(key).toDouble());
		}
		catch (const std::exception&)
		{
			// of another version with another range: the default stays
		}
	}
	m_front->refresh();
	m_expert->refresh();
	for (const auto& [stage, check] : m_stages)
		check->setChecked(settings.value("stages/" + check->objectName(), true).toBool());
	m_schema->setCurrentText(settings.value("schema", "IFC4").toString());
	m_threads->setValue(settings.value("threads", 0).toInt());
	m_seed->setValue(settings.value("seed", 1).toInt());
	m_writeIfc->setChecked(settings.value("writeIfc", false).toBool());
	const QString folder = settings.value("folder", QDir::homePath()).toString();
	m_ifcPath->setText(QDir(folder).filePath(m_clouds.front()->getName().section(" - ", 0, 0).section('.', 0, 0) + ".ifc"));
	m_presets->readSettings(settings);
	m_labels->readSettings(settings);
}

void S2BReconstructDlg::writeSettings() const
{
	QSettings settings;
	settings.beginGroup(kSettings);
	for (const s2b::ParameterInfo& info : s2b::parameterTable())
	{
		// Only what was changed is remembered, so that better defaults of a later version arrive.
		const QString key = "parameters/" + QString::fromStdString(info.name);
		if (info.value(m_parameters) == info.value(s2b::Parameters{}))
			settings.remove(key);
		else
			settings.setValue(key, info.value(m_parameters));
	}
	for (const auto& [stage, check] : m_stages)
		settings.setValue("stages/" + check->objectName(), check->isChecked());
	settings.setValue("schema", m_schema->currentText());
	settings.setValue("threads", m_threads->value());
	settings.setValue("seed", m_seed->value());
	settings.setValue("writeIfc", m_writeIfc->isChecked());
	if (m_writeIfc->isChecked())
	{
		settings.setValue("folder", QFileInfo(m_ifcPath->text()).absolutePath());
		m_epsg->remember();
	}
	m_presets->writeSettings(settings);
	m_labels->writeSettings(settings);
}
