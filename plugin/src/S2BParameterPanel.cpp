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
			addRow(*grid, s2b::findParameter(name));
		return;
	}
	QString      stage;
	QGridLayout* grid = nullptr;
	for (const s2b::ParameterInfo& info : s2b::parameterTable())
	{
		const QString itsStage = fromStd(info.name).section('.', 0, 0);
		if (itsStage != stage)
		{
			stage     = itsStage;
			auto* box = new QGroupBox(stage.left(1).toUpper() + stage.mid(1));
			grid      = new QGridLayout(box);
			column->addWidget(box);
		}
		addRow(*grid, info);
	}
	column->addStretch();
}

void S2BParameterPanel::refresh()
{
	for (const auto& show : m_refresh)
		show();
}

void S2BParameterPanel::addRow(QGridLayout& grid, const s2b::ParameterInfo& info)
{
	const double fallback = info.value(s2b::Parameters{});
	const int    row      = grid.rowCount();
	auto*        label    = new QLabel(readableName(info.name));
	auto*        reset    = new QToolButton;
	reset->setText(QString::fromUtf8("↺"));
	reset->setAutoRaise(true);
	reset->setToolTip(QString("Back to the default, %1%2").arg(fallback).arg(unitSuffix(info)));
	label->setToolTip(helpText(info));

	const auto showReset = [this, reset, fallback, &info]
	{ reset->setEnabled(info.value(m_parameters) != fallback); };
	QWidget* editor = nullptr;
	if (info.isSwitch())
	{
		auto* box = new QCheckBox;
		editor    = box;
		connect(box, &QCheckBox::toggled, this, [this, &info, showReset](bool on)
		        {
			        info.set(m_parameters, on ? 1.0 : 0.0);
			        showReset(); });
		m_refresh.emplace_back([this, box, &info, showReset]
		                       {
			                       box->setChecked(info.value(m_parameters) != 0);
			                       showReset(); });
		connect(reset, &QToolButton::clicked, box, [box, fallback]
		        { box->setChecked(fallback != 0); });
	}
	else
	{
		auto*     box      = new QuietSpinBox;
		const int decimals = info.isInteger() ? 0 : 3;
		editor             = box;
		box->setDecimals(decimals);
		box->setRange(info.minimum, info.maximum);
		box->setSingleStep(info.isInteger() ? 1 : std::max(0.001, std::min(0.1, fallback / 10)));
		box->setSuffix(unitSuffix(info));
		box->setMinimumWidth(130);
		connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, &info, showReset](double value)
		        {
			        info.set(m_parameters, value);
			        showReset(); });
		m_refresh.emplace_back([this, box, &info, showReset]
		                       {
			                       // Three decimals are shown; a finer value from a file stays as it is until it is edited.
			                       const QSignalBlocker quiet(box);
			                       box->setValue(info.value(m_parameters));
			                       showReset(); });
		connect(reset, &QToolButton::clicked, box, [box, fallback]
		        { box->setValue(fallback); });
	}
	editor->setObjectName(fromStd(info.name));
	editor->setToolTip(helpText(info));
	grid.addWidget(label, row, 0);
	grid.addWidget(editor, row, 1);
	grid.addWidget(reset, row, 2);
	grid.setColumnStretch(0, 1);
	m_refresh.back()();
}
