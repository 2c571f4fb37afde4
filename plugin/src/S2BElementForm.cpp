// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BElementForm.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace
{
	using s2b::ElementId;
	using s2b::ElementKind;
	using s2b::Measure;

	constexpr struct
	{
		Measure     measure;
		const char* name;
		const char* text;
	} kMeasures[] = {{Measure::Thickness, "thickness", "Thickness"}, {Measure::Height, "height", "Height"}, {Measure::Width, "width", "Width"}, {Measure::Depth, "depth", "Depth"}, {Measure::Sill, "sill", "Sill"}};

	const char* provenanceText(s2b::Provenance provenance)
	{
		switch (provenance)
		{
		case s2b::Provenance::Measured:
			return "measured";
		case s2b::Provenance::Corrected:
			return "corrected";
		default:
			return "assumed";
		}
	}

	// Which classes an element of one can be given.
	std::vector<std::pair<ElementKind, const char*>> kindsFor(std::optional<ElementKind> kind)
	{
		if (!kind)
			return {};
		if (kind == ElementKind::Wall || kind == ElementKind::Column)
			return {{ElementKind::Wall, "Wall"}, {ElementKind::Column, "Column"}};
		return {{ElementKind::Door, "Door"}, {ElementKind::Window, "Window"}, {ElementKind::Opening, "Opening"}};
	}
} // namespace

QDoubleSpinBox* makeLengthBox(const char* name)
{
	auto* box = new QDoubleSpinBox;
	box->setObjectName(name);
	box->setDecimals(3);
	box->setRange(0.0, 100.0);
	box->setSingleStep(0.01);
	box->setSuffix(" m");
	return box;
}

S2BElementForm::S2BElementForm(QWidget* parent)
    : QWidget(parent)
{
	auto* form = new QFormLayout(this);
	form->setContentsMargins(0, 0, 0, 0);
	m_name = new QLineEdit;
	m_name->setObjectName("name");
	m_kind = new QComboBox;
	m_kind->setObjectName("kind");
	form->addRow(tr("Name"), m_name);
	form->addRow(tr("Class"), m_kind);
	for (const auto& [measure, name, text] : kMeasures)
	{
		Row row{measure, new QLabel(tr(text)), makeLengthBox(name)};
		form->addRow(row.label, row.value);
		m_rows.push_back(row);
	}
}

void S2BElementForm::show(const s2b::Model& model, ElementId id)
{
	const s2b::Building& building = model.corrected;
	const bool           isThere  = !nameOf(building, id).empty();
	m_id                          = isThere ? id : ElementId{};
	m_name->setEnabled(isThere);
	m_name->setText(isThere ? QString::fromStdString(nameOf(model, id)) : QString());
	const auto kind = kindOf(building, m_id);
	m_kind->clear();
	for (const auto& [each, text] : kindsFor(kind))
		m_kind->addItem(tr(text), int(each));
	m_kind->setEnabled(kind.has_value());
	if (kind)
		m_kind->setCurrentIndex(m_kind->findData(int(*kind)));
	for (std::size_t i = 0; i < m_rows.size(); ++i)
	{
		Row&       row       = m_rows[i];
		const auto dimension = isThere ? measureOf(building, id, row.measure) : std::nullopt;
		row.value->setVisible(dimension.has_value());
		row.label->setVisible(dimension.has_value());
		if (!dimension)
			continue;
		row.value->setValue(dimension->value_m);
		row.shown = row.value->value();
		row.value->setToolTip(tr(provenanceText(dimension->provenance)));
		row.label->setText(tr(kMeasures[i].text) + " (" + tr(provenanceText(dimension->provenance)) + ")");
	}
}

QString S2BElementForm::name() const
{
	return m_name->text().trimmed();
}

s2b::Model S2BElementForm::apply(s2b::Model model) const
{
	model = renameElement(std::move(model), m_id, name().toStdString());
	for (const Row& row : m_rows)
	{
		if (row.value->isVisibleTo(this) && row.value->value() != row.shown)
			model.corrected = setMeasure(std::move(model.corrected), m_id, row.measure, row.value->value());
	}
	const auto kind = m_kind->isEnabled() ? std::optional(static_cast<ElementKind>(m_kind->currentData().toInt())) : std::nullopt;
	if (kind && kindOf(model.corrected, m_id) != kind)
		model.corrected = setKind(std::move(model.corrected), m_id, *kind);
	return model;
}
