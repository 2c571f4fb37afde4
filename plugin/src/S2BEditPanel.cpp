// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEditPanel.h"

#include "S2BActions.h"
#include "S2BEntities.h"
#include "S2BModel.h"
#include "S2BTreeUpdate.h"
#include "core/model/wall_axis.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <ccMainAppInterface.h>

namespace
{
	using s2b::ElementId;
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

	QDoubleSpinBox* makeLength(const char* name)
	{
		auto* box = new QDoubleSpinBox;
		box->setObjectName(name);
		box->setDecimals(3);
		box->setRange(0.0, 100.0);
		box->setSingleStep(0.01);
		box->setSuffix(" m");
		return box;
	}

	Eigen::Vector3d inBuilding(const s2b::Building& building, const CCVector3d& world)
	{
		return building.frame.toBuilding({world.x, world.y, world.z});
	}

	// The storey whose room holds a height.
	ElementId storeyAt(const s2b::Building& building, double z)
	{
		ElementId storey = building.storeys.empty() ? ElementId{} : building.storeys.front().id;
		for (const s2b::Storey& s : building.storeys)
		{
			if (s.elevation_m <= z + 0.1)
				storey = s.id;
		}
		return storey;
	}
} // namespace

S2BEditPanel::S2BEditPanel(ccMainAppInterface& app)
    : QDockWidget(tr("Edit element"), app.getMainWindow())
    , m_app(app)
    , m_picker(app)
{
	setObjectName("S2BEditPanel");
	auto* page   = new QWidget;
	auto* layout = new QVBoxLayout(page);

	m_state = new QLabel;
	m_state->setObjectName("state");
	m_state->setWordWrap(true);
	layout->addWidget(m_state);

	m_form = new QFormLayout;
	m_name = new QLineEdit;
	m_name->setObjectName("name");
	m_kind = new QComboBox;
	m_kind->setObjectName("kind");
	m_form->addRow(tr("Name"), m_name);
	m_form->addRow(tr("Class"), m_kind);
	for (const auto& [measure, name, text] : kMeasures)
	{
		Row row{measure, new QLabel(tr(text)), makeLength(name)};
		m_form->addRow(row.label, row.value);
		m_rows.push_back(row);
	}
	layout->addLayout(m_form);

	auto* grid = new QGridLayout;
	m_apply    = addButton("apply", tr("Apply"), tr("Set what was changed above"), &S2BEditPanel::apply);
	m_reset    = addButton("reset", tr("Reset"), tr("Return the element to its reconstructed state"), &S2BEditPanel::reset);
	m_merge    = addButton("merge", tr("Merge"), tr("Make one wall of the two that are selected"), &S2BEditPanel::merge);
	m_split    = addButton("split", tr("Split..."), tr("Pick the place where the wall is split"), &S2BEditPanel::split);
	m_addWall  = addButton("addWall", tr("Add wall..."), tr("Pick two points on one face of the wall, and, for its thickness, a third on the other"), &S2BEditPanel::addWall);
	m_addLevel = addButton("addLevel", tr("Add level..."), tr("Pick a point on the floor"), &S2BEditPanel::addLevel);
	int cell   = 0;
	for (QPushButton* button : {m_apply, m_reset, m_merge, m_split, m_addWall, m_addLevel})
	{
		grid->addWidget(button, cell / 2, cell % 2);
		++cell;
	}
	layout->addLayout(grid);

	auto* adding   = new QFormLayout;
	m_newThickness = makeLength("newThickness");
	m_newThickness->setRange(0.02, 2.0);
	m_newThickness->setValue(0.2);
	m_newThickness->setToolTip(tr("Of a wall that is added by two points; it lies to the left of the way from the first to the second"));
	adding->addRow(tr("Assumed thickness"), m_newThickness);
	layout->addLayout(adding);
	m_cancel = addButton("cancelPicking", tr("Stop picking"), tr("End picking; a wall with two points is added with the assumed thickness"), &S2BEditPanel::endPicking);
	layout->addWidget(m_cancel);

	m_message = new QLabel;
	m_message->setObjectName("message");
	m_message->setWordWrap(true);
	m_message->setMinimumWidth(220);
	layout->addWidget(m_message);
	layout->addStretch();
	setWidget(page);
	m_cancel->hide();
	setSelection(app.getSelectedEntities());
}

QPushButton* S2BEditPanel::addButton(const char* name, const QString& text, const QString& toolTip, void (S2BEditPanel::*onClick)())
{
	auto* button = new QPushButton(text);
	button->setObjectName(name);
	button->setToolTip(toolTip);
	connect(button, &QPushButton::clicked, this, onClick);
	return button;
}

void S2BEditPanel::say(const QString& text, bool isWrong)
{
	m_message->setStyleSheet(isWrong ? "color: #b00020" : "");
	m_message->setText(text);
}

void S2BEditPanel::setSelection(const ccHObject::Container& selection)
{
	if (m_picker.isActive()) // points are picked on clouds and models, and that selects
		return;
	m_root = nullptr;
	m_ids.clear();
	for (ccHObject* entity : selection)
	{
		ccHObject* root = s2b::modelOf({entity});
		if (!root || (m_root && m_root != root))
			return showNothing(tr("Select an element of a model, or two walls to merge."));
		m_root = root;
		for (const char* key : {s2b::kIdKey, s2b::kLevelKey, s2b::kAxisKey})
		{
			if (entity->hasMetaData(key))
			{
				m_ids.push_back({entity->getMetaData(key).toUInt()});
				break;
			}
		}
	}
	if (!m_root)
		return showNothing(tr("Select an element of a model, or two walls to merge."));
	try
	{
		show(s2b::storedModel(*m_root));
		say({});
	}
	catch (const std::exception& e)
	{
		m_root = nullptr;
		showNothing(QString::fromUtf8(e.what()));
	}
}

void S2BEditPanel::showNothing(const QString& why)
{
	m_root = nullptr;
	m_ids.clear();
	m_state->setText(why);
	show(s2b::Model{});
}

void S2BEditPanel::show(const s2b::Model& model)
{
	const s2b::Building& building = model.corrected;
	const bool           isOne    = m_ids.size() == 1 && !nameOf(building, m_ids.front()).empty();
	const ElementId      id       = isOne ? m_ids.front() : ElementId{};
	const auto           isWall   = [&](ElementId wall)
	{ return building.wall(wall) != nullptr; };

	m_name->setEnabled(isOne);
	m_name->setText(isOne ? QString::fromStdString(nameOf(model, id)) : QString());
	m_kind->clear();
	const auto kind = kindOf(building, id);
	if (kind == s2b::ElementKind::Wall || kind == s2b::ElementKind::Column)
	{
		m_kind->addItem(tr("Wall"), int(s2b::ElementKind::Wall));
		m_kind->addItem(tr("Column"), int(s2b::ElementKind::Column));
	}
	else if (kind)
	{
		m_kind->addItem(tr("Door"), int(s2b::ElementKind::Door));
		m_kind->addItem(tr("Window"), int(s2b::ElementKind::Window));
		m_kind->addItem(tr("Opening"), int(s2b::ElementKind::Opening));
	}
	m_kind->setEnabled(kind.has_value());
	if (kind)
		m_kind->setCurrentIndex(m_kind->findData(int(*kind)));
	for (Row& row : m_rows)
	{
		const auto dimension = isOne ? measureOf(building, id, row.measure) : std::nullopt;
		row.value->setVisible(dimension.has_value());
		row.label->setVisible(dimension.has_value());
		if (!dimension)
			continue;
		row.value->setValue(dimension->value_m);
		row.shown = row.value->value();
		row.value->setToolTip(tr(provenanceText(dimension->provenance)));
		row.label->setText(tr(kMeasures[static_cast<std::size_t>(&row - m_rows.data())].text) + " (" + tr(provenanceText(dimension->provenance)) + ")");
	}
	if (m_root)
	{
		const QString place = isOne ? QString::fromStdString(nameOf(building, storeyOf(building, id))) : m_root->getName();
		const QString state = !isOne                               ? tr("%1 elements").arg(m_ids.size())
		                      : nameOf(model.found, id).empty()    ? tr("added by hand")
		                      : differs(model.found, building, id) ? tr("corrected")
		                                                           : tr("as reconstructed");
		m_state->setText(place + ": " + state);
	}
	m_apply->setEnabled(isOne);
	m_reset->setEnabled(m_root && !m_ids.empty());
	m_merge->setEnabled(m_ids.size() == 2 && isWall(m_ids[0]) && isWall(m_ids[1]));
	m_split->setEnabled(isOne && isWall(id));
	m_addWall->setEnabled(m_root != nullptr);
	m_addLevel->setEnabled(m_root != nullptr);
}

bool S2BEditPanel::edit(const Change& change, const QString& done, const std::set<ElementId>& unmoved)
{
	ccHObject*           root = m_root;
	ccHObject::Container all;
	m_app.dbRootObject()->filterChildren(all, true);
	if (!root || std::find(all.begin(), all.end(), root) == all.end()) // deleted while points were picked
	{
		showNothing(tr("The model is gone."));
		return false;
	}
	const std::vector<ElementId> ids   = m_ids;
	const QString                wrong = s2b::editModel(m_app, *root, change, unmoved);
	// Entities were replaced, and the selection with them: the same elements stay in the panel.
	m_root = root;
	m_ids  = ids;
	show(s2b::storedModel(*root));
	say(wrong.isEmpty() ? done : wrong, !wrong.isEmpty());
	m_app.redrawAll();
	return wrong.isEmpty();
}

void S2BEditPanel::apply()
{
	const ElementId                         id   = m_ids.front();
	const std::string                       name = m_name->text().trimmed().toStdString();
	const auto                              kind = m_kind->isEnabled() ? std::optional(static_cast<s2b::ElementKind>(m_kind->currentData().toInt())) : std::nullopt;
	std::vector<std::pair<Measure, double>> values;
	for (const Row& row : m_rows)
	{
		if (row.value->isVisibleTo(this) && row.value->value() != row.shown)
			values.emplace_back(row.measure, row.value->value());
	}
	edit([=](s2b::Model model)
	     {
		     model = renameElement(std::move(model), id, name);
		     for (const auto& [measure, value] : values)
			     model.corrected = setMeasure(std::move(model.corrected), id, measure, value);
		     if (kind && kindOf(model.corrected, id) != kind)
			     model.corrected = setKind(std::move(model.corrected), id, *kind);
		     return model; },
	     tr("%1 was corrected.").arg(m_name->text()));
}

void S2BEditPanel::reset()
{
	const std::vector<ElementId> ids = m_ids;
	edit([=](s2b::Model model)
	     {
		     for (const ElementId id : ids)
		     {
			     model.names.erase(id);
			     if (differs(model.found, model.corrected, id))
				     model.corrected = resetElement(std::move(model.corrected), model.found, id);
		     }
		     return model; },
	     tr("As reconstructed again."),
	     {ids.begin(), ids.end()});
}

void S2BEditPanel::merge()
{
	const ElementId first  = m_ids[0];
	const ElementId second = m_ids[1];
	const bool      isDone = edit([=](s2b::Model model)
                             {
		                             model.corrected = mergeWalls(std::move(model.corrected), first, second);
		                             return model; },
                             tr("The walls are one."));
	if (isDone)
		selectElement(first);
}

void S2BEditPanel::split()
{
	const ElementId id        = m_ids.front();
	const bool      isStarted = m_picker.start([=, this](const CCVector3d& world)
                                          {
		                                          endPicking();
		                                          edit([=](s2b::Model model)
		                                               {
			                                               const s2b::WallAxis axis(*model.corrected.wall(id));
			                                               const double        s = axis.project(inBuilding(model.corrected, world).head<2>()).x();
			                                               model.corrected       = splitWall(std::move(model.corrected), id, s);
			                                               return model; },
		                                               tr("The wall was split.")); });
	m_cancel->setVisible(isStarted);
	say(isStarted ? tr("Pick the place where the wall is split.") : tr("Another tool is picking points: close it first."), !isStarted);
}

void S2BEditPanel::addLevel()
{
	const bool isStarted = m_picker.start([this](const CCVector3d& world)
	                                      {
		                                      endPicking();
		                                      edit([=](s2b::Model model)
		                                           {
			                                           model.corrected = s2b::addLevel(std::move(model.corrected), inBuilding(model.corrected, world).z());
			                                           return model; },
		                                           tr("The level was added: run Walls on it.")); });
	m_cancel->setVisible(isStarted);
	say(isStarted ? tr("Pick a point on the floor.") : tr("Another tool is picking points: close it first."), !isStarted);
}

void S2BEditPanel::addWall()
{
	m_picked.clear();
	const bool isStarted = m_picker.start([this](const CCVector3d& world)
	                                      { pickForWall(world); });
	m_cancel->setVisible(isStarted);
	say(isStarted ? tr("Pick the first point on the wall's face.") : tr("Another tool is picking points: close it first."), !isStarted);
}

void S2BEditPanel::pickForWall(const CCVector3d& world)
{
	m_picked.push_back(world);
	if (m_picked.size() == 1)
		say(tr("Pick a second point on the same face, where the wall ends."));
	else if (m_picked.size() == 2)
		say(tr("Pick a point on the other face for the thickness, or stop picking to assume %1 m.").arg(m_newThickness->value()));
	else
		endPicking();
}

void S2BEditPanel::endPicking()
{
	m_picker.stop();
	m_cancel->hide();
	say({});
	if (m_picked.size() >= 2)
		finishWall();
	m_picked.clear();
}

void S2BEditPanel::finishWall()
{
	const std::vector<CCVector3d> points    = m_picked;
	const double                  thickness = m_newThickness->value();
	ElementId                     added;
	m_picked.clear();
	const bool isDone = edit([&](s2b::Model model)
	                         {
		                         std::vector<Eigen::Vector3d> p;
		                         for (const CCVector3d& world : points)
			                         p.push_back(inBuilding(model.corrected, world));
		                         const auto third  = p.size() > 2 ? std::optional<Eigen::Vector2d>(p[2].head<2>()) : std::nullopt;
		                         const auto storey = storeyAt(model.corrected, std::min(p[0].z(), p[1].z()));
		                         model.corrected   = s2b::addWall(std::move(model.corrected), s2b::wallThrough(storey, p[0].head<2>(), p[1].head<2>(), third, thickness));
		                         added             = model.corrected.walls.back().id;
		                         return model; },
	                         tr("The wall was added."));
	if (isDone)
		selectElement(added);
}

void S2BEditPanel::selectElement(ElementId id)
{
	const auto    entities = s2b::elementEntities(*m_root);
	const auto    entity   = entities.find(id);
	const QString message  = m_message->text();
	if (entity == entities.end())
		return;
	for (ccHObject* selected : ccHObject::Container(m_app.getSelectedEntities()))
		m_app.setSelectedInDB(selected, false);
	m_app.setSelectedInDB(entity->second, true);
	setSelection({entity->second});
	say(message);
}
