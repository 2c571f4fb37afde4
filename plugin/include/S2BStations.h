// SPDX-License-Identifier: GPL-3.0-or-later
// Where the scanner stood: from the clouds' sensors, or from a file and the points' source ids.
#pragma once

#include "S2BInput.h"

#include <QString>
#include <vector>

namespace s2b
{
	//! Fills the input's stations, when anything is known of them; input.view.origin and count have to be set
	/** With a file its stations count, and the scalar field Point Source ID says which of them a point was measured from;
	    without the field that is found out from what each of them can see. Without a file the sensors (ground based
	    lidars) below the clouds count, as CloudCompare makes them from PTX files or people by hand: a cloud with a single
	    one was measured from there.
	    \param file what -STATIONS names, empty for none
	    \throws Error{BadFile} for a file that can't be used, or that does not belong to these clouds
	**/
	void addStations(const std::vector<const ccPointCloud*>& clouds, const QString& file, Input& input);
} // namespace s2b
