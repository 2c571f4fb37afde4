// SPDX-License-Identifier: GPL-3.0-or-later
// A reconstruction in words, for the console.
#pragma once

#include "core/model/building.h"

#include <QString>
#include <QStringList>

namespace s2b
{
	struct Input;

	//! What was found, one line per storey and class
	QStringList summary(const Building& building);

	//! Dimensions that no point says, with the names of the elements: one line for each kind of them, for a warning
	QStringList assumptions(const Building& building);

	//! A storey's elevation in the world, "3.036 m"
	QString elevationText(const Building& building, const Storey& storey);

	//! The classes of the labels and how many points each has, in one line
	QString labelSummary(const Input& input, const QString& mapName);

	//! One diagnostic with its element and its place in world coordinates
	QString diagnosticText(const Building& building, const Diagnostic& diagnostic);
} // namespace s2b
