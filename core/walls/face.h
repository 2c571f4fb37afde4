// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace s2b
{

/// One face of a wall: a vertical rectangle, seen from the top a line. Building frame.
///
/// Points of the face are t * s + n * offset with s in [begin, end]; n is t turned by +90 degrees.
struct Face
{
    static constexpr double kBin_m = 0.05;  ///< along the face
    static constexpr double kRow_m = 0.10;  ///< upwards, from the storey's floor

    Eigen::Vector2d t = Eigen::Vector2d::UnitX();
    double offset = 0.0;
    double begin = 0.0;
    double end = 0.0;
    int side = 0;               ///< +1: the room is on the side that n points to, -1: on the other, 0: unknown
    int scannedSide = 0;        ///< side that the scanner saw it from, 0 when not known or both
    bool isBesideRoom = false;  ///< its side is no guess: floor or ceiling was seen right beside it (on at least one
                                ///< side), or it is known from where it was scanned
    bool isLow = false;         ///< ends clearly below the ceiling (a parapet): the ceiling says nothing of its sides
    double rms_m = 0.0;
    double area_m2 = 0.0;    ///< covered by cells
    double wallShare = 0.0;  ///< of its cells, those labelled wall
    std::uint64_t points = 0;
    std::vector<std::uint64_t> rows;  ///< per bin of [begin, end]: bit r is set when the face has cells at that height

    [[nodiscard]] Eigen::Vector2d n() const { return {-t.y(), t.x()}; }
    [[nodiscard]] double length() const { return end - begin; }
    [[nodiscard]] Eigen::Vector2d at(double s) const { return t * s + n() * offset; }
};

}  // namespace s2b
