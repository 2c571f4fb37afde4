// SPDX-License-Identifier: GPL-3.0-or-later
// The actions Levels, Walls, Doors, Columns and Rooms.
#include "S2BActions.h"
#include "S2BEntities.h"
#include "S2BFindingsDock.h"
#include "S2BInput.h"
#include "S2BModel.h"
#include "S2BReconstructDlg.h"
#include "S2BSummary.h"
#include "S2BTreeUpdate.h"
#include "S2BWorker.h"
#include "core/base/error.h"
#include "core/pipeline/reconstruct_from.h"

#include <QMainWindow>
#include <ccMainAppInterface.h>
#include <ccPointCloud.h>

namespace s2b
{
	namespace
	{
		// The model and the clouds that belong together, where only one of them is selected.
		StageSelection completed(ccMainAppInterface& app, StageSelection selection)
		{
			if (selection.model && selection.clouds.empty())
			{
				selection.clouds = cloudsOfModel(*app.dbRootObject(), *selection.model);
				if (selection.clouds.empty())
					throw Error(ErrorCode::BadFile, "the cloud of " + selection.model->getName().toStdString() + " is not in the tree: open it, or select it together with the model");
			}
			if (!selection.model)
				selection.model = modelOfClouds(*app.dbRootObject(), selection.clouds);
			return selection;
		}

		// The parameters of the dialog, as they were used last.
		RunChoice rememberedChoice(ccMainAppInterface& app, const std::vector<ccPointCloud*>& clouds)
		{
			const S2BReconstructDlg dialog({clouds.begin(), clouds.end()}, app.getMainWindow());
			return dialog.choice();
		}

		// What the stages need and nobody made yet is made first; what hangs on walls is made anew with them.
		std::set<Stage> stagesFor(std::set<Stage> stages, const Model& model)
		{
			const Building& building = model.corrected;
			const bool      onWalls  = stages.count(Stage::Doors) || stages.count(Stage::Spaces);
			if (onWalls && building.walls.empty())
				stages.insert(Stage::Walls);
			if (building.storeys.empty())
				stages.insert(Stage::Levels);
			if (stages.count(Stage::Walls) && !building.slabs.empty())
				stages.insert(Stage::Slabs);
			if (stages.count(Stage::Walls) && !building.spaces.empty())
				stages.insert(Stage::Spaces);
			return stages;
		}

		// The stages alone, and before them what they need.
		std::set<Stage> stagesFromNothing(std::set<Stage> stages)
		{
			if (stages.count(Stage::Doors) || stages.count(Stage::Spaces))
				stages.insert(Stage::Walls);
			stages.insert(Stage::Levels);
			return stages;
		}

		std::optional<Model> runInWorker(ccMainAppInterface& app, const StageSelection& selection, const RunChoice& choice, const std::optional<Model>& earlier)
		{
			Context context;
			context.threads = choice.threads;
			context.seed    = choice.seed;
			std::optional<Model> result;
			runInBackground(app, context, [&](const Context& running)
			                {
				                const Input     input  = readClouds({selection.clouds.begin(), selection.clouds.end()}, choice.labels, running);
				                const ElementId storey = selection.storey;
				                if (earlier)
					                result = reconstructFrom(input.view, choice.pipeline, *earlier, storey.value ? std::optional(storey) : std::nullopt, running);
				                else
				                {
					                Building found = reconstruct(input.view, choice.pipeline, running);
					                result         = Model{found, found, {}};
				                } });
			return result;
		}

		void run(ccMainAppInterface& app, const std::set<Stage>& stages)
		{
			const StageSelection selection = completed(app, stageSelection(app.getSelectedEntities()));
			RunChoice            choice    = rememberedChoice(app, selection.clouds);
			std::optional<Model> earlier;
			std::set<ElementId>  moved;
			if (selection.model)
			{
				ModelState state       = readModel(*selection.model);
				earlier                = std::move(state.model);
				moved                  = std::move(state.moved);
				choice.pipeline.levels = givenLevelsOf(*selection.model);
			}
			choice.pipeline.stages            = earlier ? stagesFor(stages, *earlier) : stagesFromNothing(stages);
			const std::optional<Model> result = runInWorker(app, selection, choice, earlier);
			if (!result)
				return say(app, "cancelled, nothing was changed");
			if (selection.model)
			{
				for (const QString& line : summary(result->corrected))
					say(app, line);
				updateTree(app, *selection.model, *result, moved); // says what is new among the findings
			}
			else
			{
				sayResult(app, result->corrected);
				addModel(app, *result, selection.clouds);
			}
			app.redrawAll();
		}
	} // namespace

	StageSelection stageSelection(const ccHObject::Container& selection)
	{
		StageSelection found;
		for (ccHObject* entity : selection)
		{
			ccHObject* model = entity ? modelOf({entity}) : nullptr;
			if (model && (!found.model || found.model == model))
			{
				found.model  = model;
				found.storey = storeyOfEntity(*entity);
			}
			else if (!model && entity && entity->isA(CC_TYPES::POINT_CLOUD))
				found.clouds.push_back(static_cast<ccPointCloud*>(entity));
			else
				return {};
		}
		return found;
	}

	void addModel(ccMainAppInterface& app, const Model& model, const std::vector<ccPointCloud*>& clouds, const std::vector<StoreyHeights>& given)
	{
		ccHObject* tree = makeTree(model, *clouds.front(), clouds.front()->getName() + " [BIM]").release(); // the application's
		rememberClouds(*tree, clouds);
		rememberLevels(*tree, given);
		tree->setDisplay_recursive(clouds.front()->getDisplay());
		app.addToDB(tree, false, true, false, true);
		if (model.corrected.diagnostics.empty())
			return;
		auto* dock = S2BDock::of<S2BFindingsDock>(app);
		dock->setSubject(tree);
		dock->offer();
	}

	void runStages(ccMainAppInterface& app, const std::set<Stage>& stages)
	{
		if (stageSelection(app.getSelectedEntities()).isEmpty())
			return;
		try
		{
			run(app, stages);
		}
		catch (const std::bad_alloc&)
		{
			complain(app, "Not enough memory: subsample the cloud first.");
		}
		catch (const std::exception& e)
		{
			complain(app, QString::fromUtf8(e.what()));
		}
	}

	void toggleTranslucent(ccMainAppInterface& app)
	{
		ccHObject* model = modelOf(app.getSelectedEntities());
		if (!model)
			return;
		setTranslucent(*model, !isTranslucent(*model));
		app.refreshAll();
		app.redrawAll();
	}
} // namespace s2b
