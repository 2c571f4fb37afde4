// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/layout.h"

#include <cmath>
#include <numbers>

namespace s2b::sim
{

std::vector<Eigen::Vector2d> stairHole(const Shell& shell)
{
    const double x0 = shell.exterior_m / 2.0 + 0.05;
    const double y1 = shell.width_m - shell.exterior_m / 2.0 - 0.05;
    const double y0 = shell.corridorTo_m + 1.1;
    return {{x0, y0}, {x0, y1}, {x0 + 1.1, y1}, {x0 + 1.1, y0}};  // clockwise
}

Prop makeStairs(const Shell& shell, const StoreyPlan& plan)
{
    const std::vector<Eigen::Vector2d> hole = stairHole(shell);
    const double floor = plan.building().storeys[plan.storeyIndex()].elevation_m;
    const double rise = shell.clearHeight_m + shell.slab_m;
    const int steps = static_cast<int>(std::ceil(rise / 0.185));
    const double going = (hole[1].y() - hole[0].y()) / steps;
    Prop prop;
    prop.kind = "stair";
    prop.label = Label::Stair;
    prop.storey = static_cast<int>(plan.storeyIndex());
    prop.colour = {132, 132, 136};
    for (int i = 0; i < steps; ++i)
    {
        // The flight rises towards the corridor; each step is a board with its riser.
        const double top = floor + rise * (i + 1) / steps;
        const double y = hole[1].y() - going * (i + 0.5);
        prop.boxes.push_back({{hole[0].x() + 0.55, y, top - 0.09}, {0.55, going / 2.0, 0.09}, 0.0});
    }
    return prop;
}

std::vector<Prop> makeSurroundings(std::uint64_t seed, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                                   double groundLevel_m)
{
    constexpr double kMargin_m = 14.0;
    constexpr double kCell_m = 1.0;
    Random random{seed, 0x77ee};
    std::vector<Prop> props;
    Prop ground;
    ground.kind = "ground";
    ground.label = Label::Unassigned;
    ground.storey = -1;
    ground.colour = {112, 126, 92};
    const int nx = static_cast<int>((high.x() - low.x() + 2.0 * kMargin_m) / kCell_m) + 1;
    const int ny = static_cast<int>((high.y() - low.y() + 2.0 * kMargin_m) / kCell_m) + 1;
    const auto at = [&](int i, int j)
    {
        Random bump{seed, 0x9d, static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)};
        return Eigen::Vector3d(low.x() - kMargin_m + i * kCell_m, low.y() - kMargin_m + j * kCell_m,
                               groundLevel_m + 0.03 * bump.uniform(-1.0, 1.0));
    };
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
        {
            ground.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            ground.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    props.push_back(std::move(ground));

    const int trees = 6 + static_cast<int>((high.x() - low.x()) / 6.0);
    for (int t = 0; t < trees; ++t)
    {
        const Eigen::Vector2d p(random.uniform(low.x() - kMargin_m, high.x() + kMargin_m),
                                random.uniform(low.y() - kMargin_m, high.y() + kMargin_m));
        const double height = random.uniform(2.0, 5.0);
        const double radius = random.uniform(0.8, 1.8);
        const double keep = radius + 1.0;
        if (p.x() > low.x() - keep && p.x() < high.x() + keep && p.y() > low.y() - keep && p.y() < high.y() + keep)
            continue;
        Prop tree;
        tree.kind = "tree";
        tree.label = Label::Unassigned;
        tree.storey = -1;
        tree.colour = {70, 110, 60};
        tree.boxes.push_back(
            {{p.x(), p.y(), groundLevel_m + height / 2.0}, {0.12, 0.12, height / 2.0}, random.uniform(0, 3)});
        // Crown: a lumpy sphere of 12 x 8 facets.
        const auto crown = [&](int i, int j)
        {
            i = j == 0 || j == 8 ? 0 : i % 12;
            Random bump{seed, 0xc40, static_cast<std::uint64_t>(t), static_cast<std::uint64_t>(i),
                        static_cast<std::uint64_t>(j)};
            const double a = i * std::numbers::pi / 6.0;
            const double b = (j - 4) * std::numbers::pi / 8.0;
            return Eigen::Vector3d(
                Eigen::Vector3d(p.x(), p.y(), groundLevel_m + height + 0.6 * radius) +
                radius * bump.uniform(0.75, 1.2) *
                    Eigen::Vector3d(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
        };
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 8; ++j)
            {
                tree.triangles.push_back({crown(i, j), crown(i + 1, j), crown(i + 1, j + 1)});
                tree.triangles.push_back({crown(i, j), crown(i + 1, j + 1), crown(i, j + 1)});
            }
        props.push_back(std::move(tree));
    }
    return props;
}

}  // namespace s2b::sim
