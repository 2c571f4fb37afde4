// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

namespace s2b
{
	//! The number of points that the header of a LAS or LAZ file announces; nothing for any other file
	std::optional<quint64> lasPointCount(const QString& path);
} // namespace s2b
