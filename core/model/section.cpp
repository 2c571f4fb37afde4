// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b
{
namespace
{

constexpr double kSagitta_m = 0.001;  // how far a chord of a sampled circle may lie from it

std::vector<Eigen::Vector2d> outline(const RectangleSection& s)
{
    const double x = 0.5 * s.width_m, y = 0.5 * s.depth_m;
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

std::vector<Eigen::Vector2d> outline(const CircleSection& s)
{
    const double step = 2.0 * std::acos(std::clamp(1.0 - kSagitta_m / s.radius_m, 0.0, 1.0));
    const int count = std::max(24, static_cast<int>(std::ceil(2.0 * std::numbers::pi / step)));
    std::vector<Eigen::Vector2d> ring;
    for (int i = 0; i < count; ++i)
    {
        const double angle = 2.0 * std::numbers::pi * i / count;
        ring.emplace_back(s.radius_m * std::cos(angle), s.radius_m * std::sin(angle));
    }
    return ring;
}

std::vector<Eigen::Vector2d> outline(const ProfileSection& s)
{
    const double x = 0.5 * s.width_m, y = 0.5 * s.depth_m, w = 0.5 * s.web_m, f = s.flange_m;
    switch (s.shape)
    {
        case ProfileShape::I:
            return {{-x, -y}, {x, -y}, {x, f - y},  {w, f - y},  {w, y - f},  {x, y - f},
                    {x, y},   {-x, y}, {-x, y - f}, {-w, y - f}, {-w, f - y}, {-x, f - y}};
        case ProfileShape::L:
            return {{-x, -y}, {x, -y}, {x, f - y}, {s.web_m - x, f - y}, {s.web_m - x, y}, {-x, y}};
        case ProfileShape::U:
            return {{-x, -y},   {x, -y}, {x, f - y}, {s.web_m - x, f - y}, {s.web_m - x, y - f},
                    {x, y - f}, {x, y},  {-x, y}};
        case ProfileShape::T:
            return {{-w, -y}, {w, -y}, {w, y - f}, {x, y - f}, {x, y}, {-x, y}, {-x, y - f}, {-w, y - f}};
    }
    return {};
}

double flangesOf(const ProfileSection& s)
{
    return s.shape == ProfileShape::I || s.shape == ProfileShape::U ? 2.0 : 1.0;
}

}  // namespace

const char* shapeName(ProfileShape shape)
{
    switch (shape)
    {
        case ProfileShape::I:
            return "I";
        case ProfileShape::L:
            return "L";
        case ProfileShape::U:
            return "U";
        case ProfileShape::T:
            break;
    }
    return "T";
}

Eigen::Vector2d boxOf(const Section& section)
{
    if (const auto* circle = std::get_if<CircleSection>(&section))
        return Eigen::Vector2d::Constant(2.0 * circle->radius_m);
    if (const auto* profile = std::get_if<ProfileSection>(&section))
        return {profile->width_m, profile->depth_m};
    const auto& rectangle = std::get<RectangleSection>(section);
    return {rectangle.width_m, rectangle.depth_m};
}

void setBox(Section& section, const Eigen::Vector2d& box_m)
{
    if (auto* circle = std::get_if<CircleSection>(&section))
        circle->radius_m = 0.5 * box_m.x();
    else if (auto* profile = std::get_if<ProfileSection>(&section))
        profile->width_m = box_m.x(), profile->depth_m = box_m.y();
    else
        section = RectangleSection{box_m.x(), box_m.y()};
}

std::vector<Eigen::Vector2d> outlineOf(const Section& section)
{
    return std::visit([](const auto& s) { return outline(s); }, section);
}

double areaOf(const Section& section)
{
    const Eigen::Vector2d box = boxOf(section);
    if (const auto* circle = std::get_if<CircleSection>(&section))
        return std::numbers::pi * circle->radius_m * circle->radius_m;
    const auto* profile = std::get_if<ProfileSection>(&section);
    if (profile == nullptr)
        return box.x() * box.y();
    const double flanges = flangesOf(*profile) * profile->flange_m;
    return flanges * box.x() + profile->web_m * (box.y() - flanges);
}

double perimeterOf(const Section& section)
{
    const Eigen::Vector2d box = boxOf(section);
    if (const auto* circle = std::get_if<CircleSection>(&section))
        return 2.0 * std::numbers::pi * circle->radius_m;
    // Notches at the box's corners (L, T) leave its perimeter as it is; those between flanges add their two sides.
    const auto* profile = std::get_if<ProfileSection>(&section);
    return 2.0 * box.sum() +
           (profile != nullptr && flangesOf(*profile) == 2.0 ? 2.0 * (box.x() - profile->web_m) : 0.0);
}

std::string faultOf(const Section& section, double smallest_m)
{
    const auto isSize = [&](double value) { return std::isfinite(value) && value >= smallest_m; };
    const Eigen::Vector2d box = boxOf(section);
    if (!isSize(box.x()) || !isSize(box.y()))
        return "a section without extent";
    const auto* profile = std::get_if<ProfileSection>(&section);
    if (profile == nullptr)
        return {};
    if (!isSize(profile->web_m) || !isSize(profile->flange_m))
        return "a section with a web or flange without thickness";
    if (profile->shape == ProfileShape::L && profile->web_m != profile->flange_m)
        return "an L section with legs of different thickness";
    if (!isSize(box.x() - profile->web_m) || !isSize(box.y() - flangesOf(*profile) * profile->flange_m))
        return "a section whose web and flanges leave nothing between them";
    return {};
}

}  // namespace s2b
