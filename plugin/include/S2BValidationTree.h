// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "S2BValidate.h"

#include <QColor>
#include <QString>
#include <ccHObject.h>
#include <memory>

class ccShiftedObject;

namespace s2b
{
	//! The key under which an element's entity keeps its IFC GUID
	inline constexpr char kGuidKey[] = "GUID";
	//! The key under which the group of a validation keeps the folder of its report
	inline constexpr char kReportKey[] = "S2B.Report";
	//! The key that says that a group is a validation
	inline constexpr char kValidationKey[] = "S2B.Validation";

	//! The elements of a comparison, in one group for each verdict and in its colour, worst first
	/** What the report says of an element is its meta data. The caller owns the tree until it is in the DB tree.
	    \param reference gives the global shift and scale
	**/
	std::unique_ptr<ccHObject> makeValidationTree(const ValidationOutcome& outcome, const ccShiftedObject& reference, const QString& name);

	//! The validation that the selection is (a part of), or null
	ccHObject* validationOf(const ccHObject::Container& selection);

	//! The colour of an element's verdict
	QColor verdictColor(const ccHObject& element);
} // namespace s2b
