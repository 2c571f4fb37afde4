// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BEntities.h"
#include "S2BModel.h"
#include "core/base/error.h"
#include "core/corrections/corrections.h"
#include "core/corrections/fit_motion.h"
#include "core/model/wall_axis.h"

#include <algorithm>
#include <ccGenericMesh.h>
#include <ccHObjectCaster.h>
#include <ccPlane.h>
#include <ccPointCloud.h>
#include <ccPolyline.h>
#include <limits>

namespace s2b
{
	namespace
	{
		using Points = std::vector<Eigen::Vector3d>;

		struct Vertices
		{
			Points points;          //!< building frame
			double rounding_m = 0.; //!< of single precision
		};

		Vertices verticesOf(const ccHObject& entity, const Frame& frame)
		{
			Vertices vertices;
			// A polyline and a mesh have them in a cloud of their own.
			auto&                                        object  = const_cast<ccHObject&>(entity);
			const CCCoreLib::GenericIndexedCloudPersist* cloud   = nullptr;
			const ccShiftedObject*                       shifted = nullptr;
			if (ccGenericMesh* mesh = ccHObjectCaster::ToGenericMesh(&object))
			{
				cloud   = mesh->getAssociatedCloud();
				shifted = mesh->getAssociatedCloud();
			}
			else if (ccPolyline* line = ccHObjectCaster::ToPolyline(&object))
			{
				cloud   = line;
				shifted = line;
			}
			if (!cloud || !shifted)
				return vertices;
			PointCoordinateType largest = 0;
			for (unsigned i = 0; i < cloud->size(); ++i)
			{
				const CCVector3* p = cloud->getPoint(i);
				largest            = std::max({largest, std::abs(p->x), std::abs(p->y), std::abs(p->z)});
				const CCVector3d w = shifted->toGlobal3d(*p);
				vertices.points.push_back(frame.toBuilding({w.x, w.y, w.z}));
			}
			vertices.rounding_m = 4.0 * static_cast<double>(std::numeric_limits<PointCoordinateType>::epsilon() * largest) / shifted->getGlobalScale();
			return vertices;
		}

		std::array<Eigen::Vector3d, 4> cornersOf(const Building& building, const Opening& opening)
		{
			const Wall&                    host = *building.wall(opening.host);
			const WallAxis                 axis(host);
			const double                   low = host.base_m + opening.sill.value_m;
			std::array<Eigen::Vector3d, 4> corners;
			for (std::size_t i = 0; i < 4; ++i)
			{
				const Eigen::Vector2d p = axis.at(opening.offset_m + (i == 1 || i == 2 ? opening.width.value_m : 0.0));
				corners[i]              = {p.x(), p.y(), i < 2 ? low : low + opening.height.value_m};
			}
			return corners;
		}

		bool isIdentity(const Eigen::Affine3d& m)
		{
			return m.matrix() == Eigen::Matrix4d::Identity();
		}

		//! Reads one group
		class Reader
		{
		  public:
			Reader(const ccHObject& root, const std::set<ElementId>& unmoved)
			    : m_root(root)
			    , m_unmoved(unmoved)
			    , m_entities(elementEntities(root))
			{
				m_state.model = storedModel(root);
			}

			ModelState read()
			{
				// What lies elsewhere is told against the state that was drawn, with everything that it held.
				const Building drawn = m_state.model.corrected;
				findMotions(drawn);
				dropDeleted(drawn);
				rename();
				applyMotions(drawn);
				addLevels(drawn);
				return std::move(m_state);
			}

		  private:
			void findMotions(const Building& drawn)
			{
				for (const auto& [id, entity] : m_entities)
				{
					if (m_unmoved.count(id) || drawn.storey(id))
						continue;
					const std::optional<Points> expected = drawnPoints(drawn, id);
					if (!expected || expected->empty())
						continue;
					const Vertices   now      = verticesOf(*entity, drawn.frame);
					constexpr double kLeast_m = 2e-4; // nobody moves a wall by less
					const auto       motion   = fitMotion(*expected, now.points, kLeast_m + now.rounding_m);
					if (!motion)
						throw Error(ErrorCode::BadParameter, nameOf(m_state.model, id) + " was reshaped, its corners no longer form one of its kind: use Translate/Rotate or Scale, or Edit element > Reset");
					if (!isIdentity(*motion))
						m_motions.push_back({id, *motion});
				}
				ccHObject::Container all;
				m_root.filterChildren(all, true, CC_TYPES::PLANE);
				for (ccHObject* entity : all)
				{
					const auto*      plane  = static_cast<const ccPlane*>(entity);
					const CCVector3d center = plane->toGlobal3d(plane->getCenter());
					const CCVector3  normal = plane->getNormal();
					const double     z      = drawn.frame.toBuilding({center.x, center.y, center.z}).z() + kPlaneDrop_m;
					const ElementId  id{plane->getMetaData(kLevelKey).toUInt()};
					const Storey*    storey = drawn.storey(id);
					if (m_unmoved.count(id))
						continue;
					constexpr double kLevelled = 0.9999;
					if (std::abs(normal.z) < kLevelled)
						throw Error(ErrorCode::BadParameter, (storey ? storey->name : std::string("a level plane")) + " was tilted: floors are level, move its plane up or down only");
					if (!storey || !m_levels.insert(id).second) // a plane of the user's own, or a copy of one of ours
						m_addedLevels.push_back(z);
					else if (std::abs(z - storey->elevation_m) > 5e-4)
						m_motions.push_back({id, Eigen::Affine3d(Eigen::Translation3d(0, 0, z - storey->elevation_m))});
				}
			}

			std::optional<Points> drawnPoints(const Building& drawn, ElementId id) const
			{
				for (const Opening& opening : drawn.openings)
				{
					if (opening.id != id || opening.kind != OpeningKind::Plain || !drawn.wall(opening.host))
						continue;
					const auto corners = cornersOf(drawn, opening);
					return Points(corners.begin(), corners.end());
				}
				const std::optional<Solid> solid = elementSolid(drawn, id);
				return solid ? std::optional(solid->vertices) : std::nullopt;
			}

			void dropDeleted(const Building& drawn)
			{
				std::set<ElementId> bodiless;
				for (const QVariant& id : m_root.getMetaData(kBodilessKey).toList())
					bodiless.insert({id.toUInt()});
				const bool          knowsStoreys = m_root.hasMetaData(kShiftKey);
				std::set<ElementId> gone;
				const auto          look = [&](const auto& elements)
				{
					for (const auto& e : elements)
					{
						if (!m_entities.count(e.id) && !bodiless.count(e.id))
							gone.insert(e.id);
					}
				};
				look(drawn.walls);
				look(drawn.openings);
				look(drawn.columns);
				look(drawn.slabs);
				look(drawn.spaces);
				if (knowsStoreys)
					look(drawn.storeys);
				for (const Storey& storey : drawn.storeys) // its plane went, and nothing stands on it
				{
					const auto group   = m_entities.find(storey.id);
					const bool isEmpty = group != m_entities.end() && std::none_of(m_entities.begin(), m_entities.end(), [&](const auto& e)
					                                                               { return e.first != storey.id && storeyOf(drawn, e.first) == storey.id; });
					if (knowsStoreys && isEmpty && !m_levels.count(storey.id))
						gone.insert(storey.id);
				}
				Building& building = m_state.model.corrected;
				for (const ElementId id : gone)
				{
					if (!nameOf(building, id).empty()) // not with its wall or storey already
						building = removeElement(std::move(building), id);
				}
			}

			void rename()
			{
				for (const auto& [id, entity] : m_entities)
				{
					if (!nameOf(m_state.model, id).empty() && entity->getName() != QString::fromStdString(nameOf(m_state.model, id)))
						m_state.model = renameElement(std::move(m_state.model), id, entity->getName().toStdString());
				}
			}

			void applyMotions(const Building& drawn)
			{
				Building&                  building = m_state.model.corrected;
				std::vector<ElementMotion> bodies;
				std::vector<ElementMotion> openings;
				for (const ElementMotion& m : m_motions)
				{
					m_state.moved.insert(m.id);
					if (nameOf(building, m.id).empty())
						continue;
					const bool isOpening = std::any_of(building.openings.begin(), building.openings.end(), [&](const Opening& o)
					                                   { return o.id == m.id; });
					(isOpening ? openings : bodies).push_back(m);
				}
				building = moveElements(std::move(building), bodies);
				for (const ElementMotion& m : openings)
				{
					const auto opening = std::find_if(drawn.openings.begin(), drawn.openings.end(), [&](const Opening& o)
					                                  { return o.id == m.id; });
					auto       corners = cornersOf(drawn, *opening);
					// Moved together with its wall it has gone there already.
					const auto host  = std::find_if(bodies.begin(), bodies.end(), [&](const ElementMotion& b)
                                                   { return b.id == opening->host; });
					double     apart = host == bodies.end() ? 1.0 : 0.0;
					for (Eigen::Vector3d& c : corners)
					{
						const Eigen::Vector3d to = m.motion * c;
						if (host != bodies.end())
							apart = std::max(apart, (host->motion * c - to).norm());
						c = to;
					}
					if (apart > 0.001)
						building = placeOpening(std::move(building), m.id, corners);
				}
			}

			void addLevels(const Building& drawn)
			{
				for (const double z : m_addedLevels)
				{
					const bool isThere = std::any_of(drawn.storeys.begin(), drawn.storeys.end(), [&](const Storey& s)
					                                 { return std::abs(s.elevation_m - z) < 0.05; });
					if (!isThere) // a copy that was not moved yet means nothing
						m_state.model.corrected = addLevel(std::move(m_state.model.corrected), z);
				}
			}

			const ccHObject&                m_root;
			const std::set<ElementId>&      m_unmoved;
			std::map<ElementId, ccHObject*> m_entities;
			ModelState                      m_state;
			std::vector<ElementMotion>      m_motions;
			std::set<ElementId>             m_levels;
			std::vector<double>             m_addedLevels;
		};
	} // namespace

	ModelState readModel(const ccHObject& root, const std::set<ElementId>& unmoved)
	{
		return Reader(root, unmoved).read();
	}
} // namespace s2b
