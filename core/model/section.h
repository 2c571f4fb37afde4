// SPDX-License-Identifier: GPL-3.0-or-later
/// Cross sections of columns: what shape, and everything that follows from it.
#pragma once

#include <Eigen/Core>

#include <string>
#include <variant>
#include <vector>

namespace s2b
{

struct RectangleSection
{
    double width_m = 0.0;  ///< along the column's x
    double depth_m = 0.0;  ///< along the column's y
    bool operator==(const RectangleSection&) const = default;
};
struct CircleSection
{
    double radius_m = 0.0;
    bool operator==(const CircleSection&) const = default;
};

/// As IFC draws them (IfcIShapeProfileDef ...), x to the right and y up, each in the middle of its box.
enum class ProfileShape
{
    I,  ///< also H: flanges at top and bottom, the web between their middles
    L,  ///< legs at the left and at the bottom
    U,  ///< also C: web at the left, flanges at top and bottom
    T   ///< flange at the top, the web below its middle
};

/// A section of plates, sharp cornered.
struct ProfileSection
{
    ProfileShape shape = ProfileShape::I;
    double width_m = 0.0;   ///< of its box, along the column's x
    double depth_m = 0.0;   ///< of its box, along the column's y
    double web_m = 0.0;     ///< thickness of the web; of both legs of an L
    double flange_m = 0.0;  ///< thickness of the flanges; of an L the same as web_m
    bool operator==(const ProfileSection&) const = default;
};

using Section = std::variant<RectangleSection, CircleSection, ProfileSection>;

/// "I", "L", "U", "T".
[[nodiscard]] const char* shapeName(ProfileShape shape);

/// Width along the column's x, depth along its y.
[[nodiscard]] Eigen::Vector2d boxOf(const Section& section);

/// Another box; plates keep their thickness. A circle's diameter is the width.
void setBox(Section& section, const Eigen::Vector2d& box_m);

/// Corners about the middle of the box, counter-clockwise; a circle is sampled to 1 mm sagitta.
[[nodiscard]] std::vector<Eigen::Vector2d> outlineOf(const Section& section);

/// Exact, also of a circle.
[[nodiscard]] double areaOf(const Section& section);
[[nodiscard]] double perimeterOf(const Section& section);

/// Nothing when it is a solid section; otherwise what is wrong, for people: a size that is not above zero, or plates
/// that leave no notch between them.
[[nodiscard]] std::string faultOf(const Section& section, double smallest_m);

}  // namespace s2b
