// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"

#include <QString>
#include <optional>

class ccMainAppInterface;

namespace s2b
{
	struct Input;
	struct RunChoice;

	//! Reconstructs (and writes the IFC, if asked) in a worker thread behind a progress dialog with a cancel button
	/** The window stays responsive; no entity is touched.
	    \return nothing when the user cancelled: then no file was written either
	    \throws Error as reconstruct() and writeIfc() do
	**/
	std::optional<Building> reconstructInBackground(const Input& input, const RunChoice& choice, const QString& projectName, ccMainAppInterface& app);
} // namespace s2b
