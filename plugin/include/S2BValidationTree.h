// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BValidate.h"

#include <QString>
#include <memory>

class ccHObject;
class ccShiftedObject;

namespace s2b
{
	//! The key under which an element's entity keeps its IFC GUID
	inline constexpr char kGuidKey[] = "GUID";

	//! The elements of a comparison, in one group for each verdict and in its colour, worst first
	/** What the report says of an element is its meta data. The caller owns the tree until it is in the DB tree.
	    \param reference gives the global shift and scale
	**/
	std::unique_ptr<ccHObject> makeValidationTree(const ValidationOutcome& outcome, const ccShiftedObject& reference, const QString& name);
} // namespace s2b
