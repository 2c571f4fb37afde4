// SPDX-License-Identifier: GPL-3.0-or-later
// Edit element: what is done by picked points.
#include "S2BEditPanel.h"
#include "core/corrections/corrections.h"
#include "core/model/wall_axis.h"

#include <QDoubleSpinBox>
#include <QPushButton>
#include <algorithm>

namespace
{
	using s2b::ElementId;

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
