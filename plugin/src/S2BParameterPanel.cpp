// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BParameterPanel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <set>

namespace
{
	QString fromStd(const std::string& text)
	{
		return QString::fromStdString(text);
	}

	// "walls.minimumRoomHeight" -> "Minimum room height"
	QString readableName(const std::string& name)
	{
		const QString key = fromStd(name).section('.', 1);
		QString       text;
		for (const QChar c : key)
		{
			if (c.isUpper())
				text += ' ';
			text += text.isEmpty() ? c.toUpper() : c.toLower();
		}
		return text;
	}

	QString unitSuffix(const s2b::ParameterInfo& info)
	{
		if (info.unit.empty() || info.unit == "1")
			return {};
		return ' ' + fromStd(info.unit).replace("m2", QString::fromUtf8("m²"));
	}

	QString helpText(const s2b::ParameterInfo& info)
	{
		const QString range = info.isSwitch() ? QString() : QString("<br>From %1 to %2%3.").arg(info.minimum).arg(info.maximum).arg(unitSuffix(info));
		return QString("<p><b>%1</b><br>%2%3<br><i>Default: %4</i></p>").arg(fromStd(info.name), fromStd(info.help).toHtmlEscaped(), range, fromStd(info.source).toHtmlEscaped());
	}

	// A spin box in a scrolled page must not swallow the wheel that was meant for the page.
	class QuietSpinBox : public QDoubleSpinBox
	{
	  public:
		using QDoubleSpinBox::QDoubleSpinBox;

	  protected:
		void wheelEvent(QWheelEvent* event) override
		{
			event->ignore();
		}
	};
} // namespace

S2BParameterPanel::S2BParameterPanel(s2b::Parameters& parameters, const std::vector<std::string>& names, QWidget* parent)
    : QWidget(parent)
    , m_parameters(parameters)
{
	auto* column = new QVBoxLayout(this);
	column->setContentsMargins(0, 0, 0, 0);
	if (!names.empty())
	{
		auto* grid = new QGridLayout;
		column->addLayout(grid);
		for (const std::string& name : names)
			addRow(*grid, s2b::findParameter(name), nullptr);
		return;
	}
	QString      stage;
	QGridLayout* grid = nullptr;
	QWidget*     box  = nullptr;
	for (const s2b::ParameterInfo& info : s2b::parameterTable())
	{
		const QString itsStage = fromStd(info.name).section('.', 0, 0);
		if (itsStage != stage)
		{
			stage = itsStage;
			box   = new QGroupBox(stage.left(1).toUpper() + stage.mid(1));
			grid  = new QGridLayout(box);
			column->addWidget(box);
		}
		addRow(*grid, info, box);
	}
	column->addStretch();
}

void S2BParameterPanel::refresh()
{
	for (const auto& show : m_refresh)
		show();
}

void S2BParameterPanel::setFilter(const QString& text)
{
	std::set<QWidget*> shown;
	for (const Row& row : m_rows)
	{
		const bool isIn = row.text.contains(text.trimmed(), Qt::CaseInsensitive);
		for (QWidget* widget : row.widgets)
			widget->setVisible(isIn);
		if (isIn)
			shown.insert(row.box);
	}
	for (const Row& row : m_rows)
	{
		if (row.box)
			row.box->setVisible(shown.count(row.box) > 0);
	}
}

void S2BParameterPanel::addRow(QGridLayout& grid, const s2b::ParameterInfo& info, QWidget* box)
{
	const double fallback = info.value(s2b::Parameters{});
	const int    row      = grid.rowCount();
	auto*        label    = new QLabel(readableName(info.name));
	auto*        reset    = new QToolButton;
	reset->setText(QString::fromUtf8("↺"));
	reset->setAutoRaise(true);
	reset->setToolTip(QString("Back to the default, %1%2").arg(fallback).arg(unitSuffix(info)));
	label->setToolTip(helpText(info));

	// What differs from the default is seen at a glance.
	const auto showReset = [this, reset, label, fallback, &info]
	{
		const bool isChanged = info.value(m_parameters) != fallback;
		QFont      font      = label->font();
		font.setBold(isChanged);
		label->setFont(font);
		reset->setEnabled(isChanged);
	};
	QWidget* editor = nullptr;
	if (info.isSwitch())
	{
		auto* check = new QCheckBox;
		editor      = check;
		connect(check, &QCheckBox::toggled, this, [this, &info, showReset](bool on)
		        {
			        info.set(m_parameters, on ? 1.0 : 0.0);
			        showReset(); });
		m_refresh.emplace_back([this, check, &info, showReset]
		                       {
			                       check->setChecked(info.value(m_parameters) != 0);
			                       showReset(); });
		connect(reset, &QToolButton::clicked, check, [check, fallback]
		        { check->setChecked(fallback != 0); });
	}
	else
	{
		auto*     spin     = new QuietSpinBox;
		const int decimals = info.isInteger() ? 0 : 3;
		editor             = spin;
		spin->setDecimals(decimals);
		spin->setRange(info.minimum, info.maximum);
		spin->setSingleStep(info.isInteger() ? 1 : std::max(0.001, std::min(0.1, fallback / 10)));
		spin->setSuffix(unitSuffix(info));
		spin->setMinimumWidth(130);
		connect(spin, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, &info, showReset](double value)
		        {
			        info.set(m_parameters, value);
			        showReset(); });
		m_refresh.emplace_back([this, spin, &info, showReset]
		                       {
			                       // Three decimals are shown; a finer value from a file stays as it is until it is edited.
			                       const QSignalBlocker quiet(spin);
			                       spin->setValue(info.value(m_parameters));
			                       showReset(); });
		connect(reset, &QToolButton::clicked, spin, [spin, fallback]
		        { spin->setValue(fallback); });
	}
	editor->setObjectName(fromStd(info.name));
	editor->setToolTip(helpText(info));
	grid.addWidget(label, row, 0);
	grid.addWidget(editor, row, 1);
	grid.addWidget(reset, row, 2);
	Row shown{QString("%1 %2 %3").arg(readableName(info.name), fromStd(info.name), fromStd(info.help)), box, {label, editor, reset}};
	if (box) // on the page of all parameters there is room for it
	{
		auto* range = new QLabel(info.isSwitch() ? QString() : QString("%1 to %2").arg(info.minimum).arg(info.maximum));
		range->setEnabled(false); // greyed
		range->setToolTip(helpText(info));
		grid.addWidget(range, row, 3);
		shown.widgets.push_back(range);
	}
	m_rows.push_back(shown);
	grid.setColumnStretch(0, 1);
	m_refresh.back()();
}
