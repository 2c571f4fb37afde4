// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BPlanSymbols.h"

#include "S2BEntities.h"
#include "S2BModel.h"
#include "S2BView.h"
#include "solids.h"

#include <algorithm>
#include <array>
#include <ccPolyline.h>
#include <cmath>
#include <map>
#include <vector>

namespace s2b
{
	namespace
	{
		constexpr double              kStep_m      = 0.25; // along a curved wall
		constexpr PointCoordinateType kPaneWidth   = 5;    // pixels
		constexpr PointCoordinateType kOutlineSize = 2;
		const ccColor::Rgb            kPaneColor(0, 110, 220);
		const ccColor::Rgb            kOutlineColor(40, 60, 80);

		//! Where an entity of a model lies
		struct Place
		{
			unsigned                           entity = 0; //!< unique id
			std::array<PointCoordinateType, 6> box{};

			bool operator==(const Place&) const = default;
		};

		Place placeOf(ccHObject& entity)
		{
			const ccBBox    box  = entity.getOwnBB();
			const CCVector3 low  = box.minCorner();
			const CCVector3 high = box.maxCorner();
			return {entity.getUniqueID(), {low.x, low.y, low.z, high.x, high.y, high.z}};
		}

		//! The parent of all symbols: looks, whenever it is drawn, whether the model is as it was
		class PlanSymbols : public ccHObject
		{
		  public:
			PlanSymbols(ccMainAppInterface& app, const ccHObject& tree, std::function<void()> onChange)
			    : ccHObject("S2B plan symbols")
			    , m_app(app)
			    , m_tree(tree.getUniqueID())
			    , m_onChange(std::move(onChange))
			{
				for (ccHObject* entity : elementsOf(tree))
					m_places.push_back(placeOf(*entity));
			}

			void addSymbol(std::unique_ptr<ccHObject> symbol, ccHObject& window)
			{
				m_symbols[window.getUniqueID()] = {symbol.get(), placeOf(window)};
				addChild(symbol.release());
			}

			void draw(CC_DRAW_CONTEXT& context) override
			{
				if (MACRO_Draw3D(context))
					look();
				ccHObject::draw(context);
			}

		  private:
			struct Symbol
			{
				ccHObject* entity = nullptr;
				Place      window;
			};

			static ccHObject::Container elementsOf(const ccHObject& tree)
			{
				ccHObject::Container all;
				tree.filterChildren(all, true);
				all.erase(std::remove_if(all.begin(), all.end(), [](const ccHObject* e)
				                         { return !e->hasMetaData(kIdKey) && !e->hasMetaData(kLevelKey); }),
				          all.end());
				return all;
			}

			void look()
			{
				for (const auto& [id, symbol] : m_symbols)
					symbol.entity->setEnabled(false);
				std::vector<Place> places;
				if (const ccHObject* tree = findEntity(m_app, m_tree))
				{
					for (ccHObject* entity : elementsOf(*tree))
					{
						places.push_back(placeOf(*entity));
						const auto symbol = m_symbols.find(places.back().entity);
						if (symbol != m_symbols.end() && symbol->second.window == places.back())
							symbol->second.entity->setEnabled(entity->isVisible() && entity->isBranchEnabled());
					}
				}
				if (places == m_places)
					return;
				m_places = std::move(places);
				m_onChange();
			}

			ccMainAppInterface&        m_app;
			unsigned                   m_tree; //!< unique id
			std::function<void()>      m_onChange;
			std::vector<Place>         m_places;  //!< of all elements, when last looked at
			std::map<unsigned, Symbol> m_symbols; //!< by the unique ids of their windows
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

		std::unique_ptr<ccHObject> makeSymbol(const ccHObject& window, const Building& building, const Wall& wall, const Opening& opening, const ccShiftedObject& reference, double z)
		{
			std::vector<Eigen::Vector3d>       outline = alongHole(wall, opening, 1, z);
			const std::vector<Eigen::Vector3d> other   = alongHole(wall, opening, -1, z);
			outline.insert(outline.end(), other.rbegin(), other.rend());
			auto hole = makePolyline(building, reference, outline, true, kOutlineColor, "hole");
			auto pane = makePolyline(building, reference, alongHole(wall, opening, 0, z), false, kPaneColor, "pane");
			hole->setWidth(kOutlineSize);
			pane->setWidth(kPaneWidth);
			auto symbol = std::make_unique<ccHObject>(window.getName());
			symbol->addChild(hole.release());
			symbol->addChild(pane.release());
			return symbol;
		}
	} // namespace

	std::unique_ptr<ccHObject> makePlanSymbols(ccMainAppInterface& app, const ccHObject& tree, const Building& building, ElementId storey, const ccShiftedObject& reference, double cut_m, std::function<void()> onChange)
	{
		auto       symbols  = std::make_unique<PlanSymbols>(app, tree, std::move(onChange));
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
			symbols->addSymbol(makeSymbol(*entity->second, building, *wall, opening, reference, cut_m), *entity->second);
		}
		return symbols;
	}
} // namespace s2b
