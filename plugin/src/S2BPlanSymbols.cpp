// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BPlanSymbols.h"

#include "S2BEntities.h"
#include "S2BModel.h"
#include "S2BView.h"
#include "solids.h"

#include <algorithm>
#include <ccPolyline.h>
#include <cmath>

namespace s2b
{
	namespace
	{
		constexpr double              kStep_m      = 0.25; // along a curved wall
		constexpr PointCoordinateType kPaneWidth   = 5;    // pixels
		constexpr PointCoordinateType kOutlineSize = 2;
		const ccColor::Rgb            kPaneColor(0, 110, 220);
		const ccColor::Rgb            kOutlineColor(40, 60, 80);

		//! Seen as long as its window is
		class WindowSymbol : public ccHObject
		{
		  public:
			WindowSymbol(ccMainAppInterface& app, unsigned window)
			    : m_app(app)
			    , m_window(window)
			{
			}

			void draw(CC_DRAW_CONTEXT& context) override
			{
				const ccHObject* window = findEntity(m_app, m_window);
				if (window && window->isVisible() && window->isBranchEnabled())
					ccHObject::draw(context);
			}

		  private:
			ccMainAppInterface& m_app;
			unsigned            m_window; //!< unique id
		};

		// Points along the hole, beside the axis by a share of half the thickness.
		std::vector<Eigen::Vector3d> alongHole(const Wall& wall, const Opening& opening, double side, double z)
		{
			const int                    pieces = wall.bulge == 0 ? 1 : std::max(4, static_cast<int>(std::ceil(opening.width.value_m / kStep_m)));
			std::vector<Eigen::Vector3d> points;
			for (int i = 0; i <= pieces; ++i)
			{
				const AxisPoint       axis = pointOnAxis(wall, opening.offset_m + opening.width.value_m * i / pieces);
				const Eigen::Vector2d p    = axis.position + 0.5 * side * wall.thickness.value_m * axis.normal;
				points.emplace_back(p.x(), p.y(), z);
			}
			return points;
		}

		std::unique_ptr<ccHObject> makeSymbol(ccMainAppInterface& app, const ccHObject& window, const Building& building, const Wall& wall, const Opening& opening, const ccShiftedObject& reference, double z)
		{
			std::vector<Eigen::Vector3d>       outline = alongHole(wall, opening, 1, z);
			const std::vector<Eigen::Vector3d> other   = alongHole(wall, opening, -1, z);
			outline.insert(outline.end(), other.rbegin(), other.rend());
			auto hole = makePolyline(building, reference, outline, true, kOutlineColor, "hole");
			auto pane = makePolyline(building, reference, alongHole(wall, opening, 0, z), false, kPaneColor, "pane");
			hole->setWidth(kOutlineSize);
			pane->setWidth(kPaneWidth);
			auto symbol = std::make_unique<WindowSymbol>(app, window.getUniqueID());
			symbol->setName(window.getName());
			symbol->addChild(hole.release());
			symbol->addChild(pane.release());
			return symbol;
		}
	} // namespace

	std::unique_ptr<ccHObject> makePlanSymbols(ccMainAppInterface& app, const ccHObject& tree, const Building& building, ElementId storey, const ccShiftedObject& reference, double cut_m)
	{
		auto       symbols  = std::make_unique<ccHObject>("S2B plan symbols");
		const auto entities = elementEntities(tree);
		for (const Opening& opening : building.openings)
		{
			const Wall* wall   = building.wall(opening.host);
			const auto  entity = entities.find(opening.id);
			if (opening.kind != OpeningKind::Window || !wall || wall->storey != storey || entity == entities.end())
				continue;
			const double sill = wall->base_m + opening.sill.value_m;
			if (cut_m <= sill || cut_m >= sill + opening.height.value_m)
				continue;
			symbols->addChild(makeSymbol(app, *entity->second, building, *wall, opening, reference, cut_m).release());
		}
		return symbols->getChildrenNumber() ? std::move(symbols) : nullptr;
	}
} // namespace s2b
