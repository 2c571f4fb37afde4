// SPDX-License-Identifier: GPL-3.0-or-later
// A building as text, so that it is kept with its entities and survives a save to .bin.
#pragma once

#include "core/model/building.h"

#include <QString>

namespace s2b
{
	//! The whole building as JSON; the same building gives the same text
	QString buildingText(const Building& building);

	//! What buildingText() wrote
	/** \throws Error{BadFile} when it is something else **/
	Building parseBuilding(const QString& text);
} // namespace s2b
