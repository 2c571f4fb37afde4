// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEditPanel.h"

#include "S2BActions.h"
#include "S2BElementForm.h"
#include "S2BEntities.h"
#include "S2BModel.h"
#include "S2BTreeUpdate.h"
#include "core/corrections/corrections.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <ccMainAppInterface.h>

using s2b::ElementId;

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

	m_form = new S2BElementForm;
	layout->addWidget(m_form);

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
	m_newThickness = makeLengthBox("newThickness");
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

	m_form->show(model, id);
	if (m_root)
	{
		const QString place = isOne ? QString::fromStdString(nameOf(building, storeyOf(building, id))) : m_root->getName();
		const QString state = m_ids.empty()                        ? tr("no element is selected")
		                      : !isOne                             ? tr("%1 elements").arg(m_ids.size())
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
	edit([this](const s2b::Model& model)
	     { return m_form->apply(model); },
	     tr("%1 was corrected.").arg(m_form->name()));
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
