// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/validation.h"

#include <QString>

namespace s2b
{
	//! "validation.tolerance=20", as -SET takes it
	/** \return false when the name does not begin with "validation."
	    \throws Error{BadParameter} for a name or value that is not known, naming what is
	**/
	bool setValidationParameter(validation::ValidationParams& params, const QString& assignment);

	//! Checks them together: the limits of the accuracy bands have to shrink
	/** \throws Error{BadParameter} **/
	void checkValidationParameters(const validation::ValidationParams& params);
} // namespace s2b
