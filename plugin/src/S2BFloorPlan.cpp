// SPDX-License-Identifier: GPL-3.0-or-later
#include "S2BFloorPlan.h"

#include "S2BActions.h"
#include "S2BModel.h"
#include "S2BPlanSymbols.h"
#include "S2BView.h"

#include <QMainWindow>
#include <QPointer>
#include <QTimer>
#include <ccGLWindowInterface.h>
#include <ccMainAppInterface.h>
#include <ccPointCloud.h>
#include <cmath>
#include <memory>
#include <optional>

namespace s2b
{
	namespace
	{
		constexpr double kBelow_m = 0.4; // under the floor, so that its slab is seen and the storey below is not

		//! Where to cut, in the entities' own coordinates
		struct Cut
		{
			unsigned  model = 0; //!< unique id
			ElementId storeyId;  //!< none of a cloud alone
			QString   storey;
			double    low     = 0.0;
			double    high    = 0.0;
			double    yaw_rad = 0.0;
			ccBBox    box;

			std::unique_ptr<ccHObject> symbols; //!< of the windows that are cut; null once the view has them, and of a cloud alone
		};

		//! What the plan changed, to be put back
		struct Plan
		{
			Cut                   cut;
			ccGLWindowInterface*  view = nullptr;    //!< only compared with the active one
			QPointer<QObject>     life;              //!< null once the view is gone
			ccHObject*            symbols = nullptr; //!< the view's own, as long as it lives
			ccViewportParameters  before;
			std::vector<unsigned> clipped; //!< unique ids
		};
		std::optional<Plan> currentPlan;

		void renewPlan(ccMainAppInterface& app);

		Cut cutOfStorey(ccMainAppInterface& app, const ccHObject& model, const Building& building, const Storey& storey)
		{
			const auto reference = referenceOf(model);
			const auto toLocal   = [&](const Eigen::Vector2d& p, double z_m)
			{
				const Eigen::Vector3d world = building.frame.toWorld({p.x(), p.y(), z_m});
				return reference->toLocal3d(CCVector3d(world.x(), world.y(), world.z()));
			};
			Cut cut;
			cut.model    = model.getUniqueID();
			cut.storeyId = storey.id;
			cut.storey   = QString::fromStdString(storey.name);
			cut.low      = toLocal({0, 0}, storey.elevation_m - kBelow_m).z;
			cut.high     = toLocal({0, 0}, storey.elevation_m + kPlanCut_m).z;
			cut.yaw_rad  = building.frame.yaw_rad;
			for (const Wall& wall : building.walls)
			{
				for (const Eigen::Vector2d& end : {wall.start, wall.end})
				{
					if (wall.storey == storey.id)
						cut.box.add(toLocal(end, storey.elevation_m).toPC());
				}
			}
			// Not while something is drawn: neither the tree nor what is drawn may change then.
			const auto onChange = [&app]
			{ QTimer::singleShot(0, app.getMainWindow(), [&app]
				                 { renewPlan(app); }); };
			cut.symbols = makePlanSymbols(app, model, building, storey.id, *reference, storey.elevation_m + kPlanCut_m, onChange);
			if (!cut.box.isValid())
				cut.box = const_cast<ccHObject&>(model).getDisplayBB_recursive(false); // changes nothing, but is not const
			return cut;
		}

		std::optional<Cut> cutOfModel(ccMainAppInterface& app, const ccHObject& model, const ccHObject& selected)
		{
			const Building building = correctedModel(model);
			if (building.storeys.empty())
				return {};
			const Storey* storey = building.storey(storeyOfEntity(selected));
			return cutOfStorey(app, model, building, storey ? *storey : building.storeys.front());
		}

		// Of a cloud alone: above its lowest points.
		Cut cutOfCloud(ccPointCloud& cloud)
		{
			Cut cut;
			cut.box    = cloud.getOwnBB();
			cut.model  = cloud.getUniqueID();
			cut.storey = cloud.getName();
			cut.low    = cut.box.minCorner().z;
			cut.high   = cut.low + kPlanCut_m * cloud.getGlobalScale();
			return cut;
		}

		void clipAll(ccMainAppInterface& app, Plan& plan)
		{
			ccHObject::Container all;
			app.dbRootObject()->filterChildren(all, true);
			for (ccHObject* entity : all)
			{
				if (!entity->isKindOf(CC_TYPES::POINT_CLOUD) && !entity->isKindOf(CC_TYPES::MESH) && !entity->isKindOf(CC_TYPES::POLY_LINE))
					continue;
				ccClipPlane below;
				below.equation = Tuple4Tpl<double>(0.0, 0.0, -1.0, plan.cut.high);
				ccClipPlane above;
				above.equation = Tuple4Tpl<double>(0.0, 0.0, 1.0, -plan.cut.low);
				entity->addClipPlanes(below);
				entity->addClipPlanes(above);
				plan.clipped.push_back(entity->getUniqueID());
			}
		}

		void unclipAll(ccMainAppInterface& app, const Plan& plan)
		{
			for (const unsigned id : plan.clipped)
			{
				if (ccHObject* entity = findEntity(app, id))
					entity->removeAllClipPlanes();
			}
		}

		void lookFromAbove(ccGLWindowInterface& view, const Cut& cut)
		{
			view.setPerspectiveState(false, true);
			view.setCustomView(CCVector3d(0, 0, -1), CCVector3d(-std::sin(cut.yaw_rad), std::cos(cut.yaw_rad), 0), false);
			view.updateConstellationCenterAndZoom(&cut.box);
			view.redraw();
		}

		// Not in the DB tree: they are neither to be saved nor to be edited.
		void drawSymbols(Plan& plan)
		{
			plan.life = plan.view->asQObject();
			if (!plan.cut.symbols)
				return;
			plan.symbols = plan.cut.symbols.release();
			plan.view->addToOwnDB(plan.symbols, false);
			plan.symbols->setDisplay_recursive(plan.view);
		}

		void removeSymbols(const Plan& plan)
		{
			if (plan.life && plan.symbols)
				plan.view->removeFromOwnDB(plan.symbols);
		}

		// The plan follows corrections of its model: what they drew anew is not cut yet, and windows may be elsewhere. The view
		// stays where the user has it.
		void renewPlan(ccMainAppInterface& app)
		{
			if (!currentPlan || !currentPlan->life)
				return;
			Plan&            plan  = *currentPlan;
			const ccHObject* model = findEntity(app, plan.cut.model);
			if (!model)
				return;
			try
			{
				const Building building = correctedModel(*model);
				const Storey*  storey   = building.storey(plan.cut.storeyId);
				if (!storey)
					return;
				Cut cut = cutOfStorey(app, *model, building, *storey);
				unclipAll(app, plan);
				removeSymbols(plan);
				plan.cut = std::move(cut);
				plan.clipped.clear();
				clipAll(app, plan);
				drawSymbols(plan);
				plan.view->redraw();
			}
			catch (const std::exception& e) // an element that was tilted, say: nothing is drawn of it
			{
				say(app, QString::fromUtf8(e.what()), true);
			}
		}

		std::optional<Cut> cutOf(ccMainAppInterface& app, const ccHObject::Container& selection)
		{
			if (ccHObject* model = modelOf(selection))
				return cutOfModel(app, *model, *selection.front());
			const std::vector<ccPointCloud*> clouds = cloudsOf(selection);
			return clouds.empty() ? std::nullopt : std::optional<Cut>(cutOfCloud(*clouds.front()));
		}
	} // namespace

	bool canToggleFloorPlan(const ccHObject::Container& selection)
	{
		return currentPlan || modelOf(selection) || !cloudsOf(selection).empty();
	}

	void toggleFloorPlan(ccMainAppInterface& app)
	{
		ccGLWindowInterface* view = app.getActiveGLWindow();
		std::optional<Cut>   next;
		try
		{
			next = cutOf(app, app.getSelectedEntities());
		}
		catch (const std::exception& e) // an element that was tilted, say
		{
			return complain(app, QString::fromUtf8(e.what()));
		}
		std::optional<Plan> last = std::exchange(currentPlan, std::nullopt);
		if (last)
		{
			unclipAll(app, *last);
			removeSymbols(*last);
		}
		const bool isAnother = last && next && (last->cut.storey != next->storey || last->cut.model != next->model);
		if (view && next && (!last || isAnother))
		{
			Plan plan;
			plan.cut    = std::move(*next);
			plan.view   = view;
			plan.before = last && last->view == view ? last->before : view->getViewportParameters();
			clipAll(app, plan);
			drawSymbols(plan);
			lookFromAbove(*view, plan.cut);
			say(app, QString("floor plan of %1, cut %2 m above its floor; choose Floor plan again to go back").arg(plan.cut.storey).arg(kPlanCut_m));
			currentPlan = std::move(plan);
		}
		else if (view && last && last->view == view)
		{
			view->setViewportParameters(last->before);
			view->redraw();
		}
		app.redrawAll();
	}
} // namespace s2b
