// SPDX-License-Identifier: GPL-3.0-or-later
/// Files of a survey. Each is written beside its path and renamed: never a partial file. Same survey, same bytes.
#pragma once

#include "tests/simulator/scanner.h"

#include <string>

namespace s2b::sim
{

/// LAS 1.4, point format 7: coordinates to 1 mm with the origin's whole metres as offset, classification = s2b codes,
/// RGB, point source id = station + 1. Compressed when the path ends in .laz.
/// @throws Error{CannotWrite, BadCoordinates}
void writeLas(const Survey& survey, const std::string& path);

/// Binary PLY: x y z (double when the origin is not zero, else float), red green blue, scalar_Classification (float, as
/// CloudCompare names it). @throws Error{CannotWrite}
void writePly(const Survey& survey, const std::string& path);

/// Text: "x y z label" a line, 4 decimals. @throws Error{CannotWrite}
void writeXyz(const Survey& survey, const std::string& path);

/// By extension: .laz, .las, .ply, .xyz, .txt. @throws Error{CannotWrite, BadParameter} for another extension.
void writeSurvey(const Survey& survey, const std::string& path);

/// Finds out before the work whether writeSurvey (`isSurvey`), or a file of any extension, can be written there.
/// @throws as writeSurvey.
void checkWritable(const std::string& path, bool isSurvey);

}  // namespace s2b::sim
