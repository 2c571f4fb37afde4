// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BPresetBar.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSettings>
#include <QStringList>

namespace
{
	QString text(const std::string& utf8)
	{
		return QString::fromStdString(utf8);
	}

	// What a preset sets and why, as a table.
	QString reasons(const s2b::Preset& preset)
	{
		QString rows;
		for (const s2b::PresetValue& value : preset.values)
		{
			const s2b::ParameterInfo& info = s2b::findParameter(value.parameter);
			const QString             unit = info.unit == "1" ? QString() : text(info.unit);
			rows += QString("<tr><td>%1&nbsp;</td><td align='right'>%2&nbsp;%3&nbsp;&nbsp;</td><td>%4</td></tr>").arg(text(info.name)).arg(value.value).arg(unit, text(value.reason).toHtmlEscaped());
		}
		return QString("<p><b>%1</b> %2</p><table>%3</table>").arg(text(preset.title), text(preset.help).toHtmlEscaped(), rows);
	}
} // namespace

S2BPresetBar::S2BPresetBar(s2b::Parameters& parameters, QWidget* parent)
    : QWidget(parent)
    , m_parameters(parameters)
{
	auto* grid = new QGridLayout(this);
	grid->setContentsMargins(0, 0, 0, 0);
	struct Kind
	{
		s2b::PresetKind kind;
		const char*     label;
		const char*     name;
		const char*     none;
	};
	int column = 0;
	for (const Kind& kind : {Kind{s2b::PresetKind::Building, "Building", "buildingPreset", "Any"}, Kind{s2b::PresetKind::Survey, "Survey", "surveyPreset", "Tripod scanner"}})
	{
		auto* choice = new QComboBox;
		choice->setObjectName(kind.name);
		choice->addItem(kind.none, QString());
		for (const s2b::Preset& preset : s2b::presetTable())
		{
			if (preset.kind != kind.kind)
				continue;
			choice->addItem(text(preset.title), text(preset.name));
			choice->setItemData(choice->count() - 1, reasons(preset), Qt::ToolTipRole);
		}
		grid->addWidget(new QLabel(kind.label), 0, column++);
		grid->addWidget(choice, 0, column++);
		m_choices[kind.kind] = choice;
		connect(choice, qOverload<int>(&QComboBox::activated), this, [this]
		        { apply(); });
	}
	grid->setColumnStretch(1, 1);
	grid->setColumnStretch(3, 1);
	m_hint = new QLabel;
	m_hint->setObjectName("presetHint");
	m_hint->setWordWrap(true);
	grid->addWidget(m_hint, 1, 0, 1, 4);
	showHint();
}

void S2BPresetBar::apply()
{
	// What the last presets said goes back to the defaults first.
	for (const auto& [kind, name] : m_applied)
	{
		if (name.empty())
			continue;
		for (const s2b::PresetValue& value : s2b::findPreset(name).values)
		{
			const s2b::ParameterInfo& info = s2b::findParameter(value.parameter);
			info.set(m_parameters, info.value(s2b::Parameters{}));
		}
	}
	for (const auto& [kind, choice] : m_choices)
	{
		m_applied[kind] = choice->currentData().toString().toStdString();
		if (!m_applied[kind].empty())
			s2b::applyPreset(m_parameters, s2b::findPreset(m_applied[kind]));
	}
	showHint();
	Q_EMIT applied();
}

void S2BPresetBar::clear()
{
	m_applied.clear();
	for (const auto& [kind, choice] : m_choices)
		choice->setCurrentIndex(0);
	showHint();
}

void S2BPresetBar::showHint()
{
	QStringList lines;
	for (const auto& [kind, choice] : m_choices)
	{
		choice->setToolTip(choice->currentData(Qt::ToolTipRole).toString());
		const std::string name = choice->currentData().toString().toStdString();
		if (!name.empty())
			lines << text(s2b::findPreset(name).help);
	}
	m_hint->setText(lines.join("<br>"));
	m_hint->setVisible(!lines.isEmpty());
}

void S2BPresetBar::readSettings(const QSettings& settings)
{
	for (const auto& [kind, choice] : m_choices)
	{
		// The parameters themselves are remembered one by one.
		const int index = choice->findData(settings.value("presets/" + choice->objectName()));
		choice->setCurrentIndex(std::max(0, index));
		m_applied[kind] = choice->currentData().toString().toStdString();
	}
	showHint();
}

void S2BPresetBar::writeSettings(QSettings& settings) const
{
	for (const auto& [kind, choice] : m_choices)
		settings.setValue("presets/" + choice->objectName(), choice->currentData());
}
