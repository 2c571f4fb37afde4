// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/validation/bim.h"

#include <string>

namespace s2b::validation
{

/// Reads models of the CV4AEC challenge (3D building model reconstruction, CVPR workshops 2022 to 2024; layout:
/// github.com/GradientSpaces/cv4aec-challenge, 3d_matching_eval/README.md).
///
/// A model is files MODEL_FLOOR_walls.json, ..._doors.json and ..._columns.json, each a list of objects: walls with
/// start_pt and end_pt (of the centre line's lower edge), width (thickness) and height; doors and columns with loc
/// (middle of the lower face), width, depth, height and rotation (degrees). Metres; what is missing is 0. Also taken:
/// one object with the lists "walls", "doors" and "columns".
///
/// Each floor becomes a storey at its walls' median lower edge. A door belongs to the wall it lies in and is drawn
/// flush with it, as doors of IFC files are; the challenge's own script takes it as it is.
/// @param path  one of the files (all others of its model in the same folder are read too), or a folder with one model.
/// @throws Error{BadFile} for a file that is not such a list, a folder without or with several models.
[[nodiscard]] Bim readCv4aec(const std::string& path);

}  // namespace s2b::validation
