// SPDX-License-Identifier: GPL-3.0-or-later
// A model as its group in the DB tree keeps it: what was found, what people corrected, and whose points it is.
#pragma once

#include "core/corrections/model.h"
#include "core/pipeline/pipeline.h"

#include <ccHObject.h>
#include <memory>
#include <set>
#include <vector>

class ccPointCloud;

namespace s2b
{
	//! What a model's group keeps as meta data, beside the building that was found
	inline constexpr char kCorrectedKey[] = "S2B.Corrected"; //!< only where people corrected something
	inline constexpr char kNamesKey[]     = "S2B.Names";
	inline constexpr char kCloudsKey[]    = "S2B.Clouds";
	inline constexpr char kShiftKey[]     = "S2B.Shift";
	inline constexpr char kGivenKey[]     = "S2B.Given";    //!< the levels that the user gave before the run
	inline constexpr char kPlanKey[]      = "S2B.Plan";     //!< how far the level planes reach
	inline constexpr char kBodilessKey[]  = "S2B.Bodiless"; //!< ids of elements that have nothing to draw
	//! And its entities, beside the id
	inline constexpr char kLevelKey[] = "S2B.Level"; //!< of a level plane: its storey
	inline constexpr char kAxisKey[]  = "S2B.Axis";  //!< of a wall's axis: its wall
	inline constexpr char kShapeKey[] = "S2B.Shape"; //!< changes when the entity has to be drawn anew

	//! Writes the model into its group's meta data
	void storeModel(ccHObject& root, const Model& model);

	//! The model in a group's meta data, without what was done to its entities since
	/** \throws Error{BadFile} when it holds none **/
	Model storedModel(const ccHObject& root);

	//! A model as its entities stand
	struct ModelState
	{
		Model               model;
		std::set<ElementId> moved; //!< whose entities lie elsewhere than the stored model says
	};

	//! Reads a group: what was deleted from it is gone, what was renamed has its new name, what was moved, turned or
	//! scaled with CloudCompare's tools is where it now lies (see core/corrections)
	/** \param unmoved  elements whose entities' motion does not count
	    \throws Error{BadFile} as storedModel(), Error{BadParameter} for a motion that an element can't take
	**/
	ModelState readModel(const ccHObject& root, const std::set<ElementId>& unmoved = {});

	//! An empty cloud with the global shift and scale of a model's entities
	std::unique_ptr<ccPointCloud> referenceOf(const ccHObject& root);

	//! Notes which clouds a model was reconstructed from
	void rememberClouds(ccHObject& root, const std::vector<ccPointCloud*>& clouds);

	//! The clouds that a model was reconstructed from, found again also after reopening; empty when one is missing
	std::vector<ccPointCloud*> cloudsOfModel(const ccHObject& dbRoot, const ccHObject& root);

	//! Notes the levels that were given instead of found ones: the stage Levels takes them again
	void                       rememberLevels(ccHObject& root, const std::vector<StoreyHeights>& levels);
	std::vector<StoreyHeights> givenLevelsOf(const ccHObject& root);

	//! The newest model of just these clouds, or null
	ccHObject* modelOfClouds(const ccHObject& dbRoot, const std::vector<ccPointCloud*>& clouds);

	//! The storey that an entity of a model belongs to, if any
	ElementId storeyOfEntity(const ccHObject& entity);

	//! The entities of a group that stand for elements, by id
	std::map<ElementId, ccHObject*> elementEntities(const ccHObject& root);
} // namespace s2b
