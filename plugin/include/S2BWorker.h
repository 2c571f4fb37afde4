// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/context.h"
#include "core/model/building.h"

#include <QString>
#include <functional>
#include <optional>
#include <vector>

class ccMainAppInterface;
class ccPointCloud;

namespace s2b
{
	struct Input;
	struct LabelChoice;
	struct RunChoice;

	//! Runs some work in a worker thread behind a progress dialog with a cancel button
	/** The window stays responsive. The work touches no entity and no widget.
	    \param context its threads and seed are taken; what is told and whether to stop is set here
	    \return false when the user cancelled
	    \throws what the work throws, but Cancelled
	**/
	bool runInBackground(ccMainAppInterface& app, Context context, const std::function<void(const Context&)>& work);

	//! Within some work: makeInput(), which takes its time with millions of points, and what it found said in the console
	Input readClouds(const std::vector<const ccPointCloud*>& clouds, const LabelChoice& labels, const Context& running);

	//! Reads the clouds, reconstructs, and writes the IFC if asked, in the background
	/** What the labels are, and why there are none, is said in the console.
	    \return nothing when the user cancelled: then no file was written either
	    \throws Error as makeInput(), reconstruct() and writeIfc() do
	**/
	std::optional<Building> reconstructInBackground(const std::vector<const ccPointCloud*>& clouds, const RunChoice& choice, const QString& projectName, ccMainAppInterface& app);
} // namespace s2b
