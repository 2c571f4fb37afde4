// SPDX-License-Identifier: GPL-3.0-or-later
/// BIMs and clouds of a few boxes, whose scores can be worked out by hand.
#pragma once

#include "core/base/error.h"
#include "core/validation/extrude.h"
#include "core/validation/validation.h"

#include <Eigen/Core>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace s2b::test
{

using namespace validation;

inline Polygon rectangle(double x0, double y0, double x1, double y1)
{
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

/// An upright box.
inline BimElement box(ElementClass elementClass, const Polygon& plan, double low_m, double high_m)
{
    BimElement e;
    e.elementClass = elementClass;
    e.plan = plan;
    e.low_m = low_m;
    e.high_m = high_m;
    return e;
}

/// A straight wall.
inline BimElement wall(const Eigen::Vector2d& start, const Eigen::Vector2d& end, double thickness_m, double low_m = 0.0,
                       double high_m = 3.0)
{
    const Eigen::Vector2d u = (end - start).normalized();
    const Eigen::Vector2d half = 0.5 * thickness_m * Eigen::Vector2d(-u.y(), u.x());
    BimElement e = box(ElementClass::Wall, {{start - half, end - half, end + half, start + half}, {}}, low_m, high_m);
    e.axis = WallAxis{start, end, thickness_m};
    return e;
}

inline Bim bimOf(std::vector<BimElement> elements, const std::string& file = "a.ifc")
{
    Bim bim;
    bim.file = file;
    bim.elements = std::move(elements);
    addMeshes(bim);
    return bim;
}

inline BimElement notSeen(BimElement e)
{
    e.visibility = Visibility{.counts = false, .bandLow_m = {}, .bandHigh_m = {}};
    return e;
}

struct Points
{
    std::vector<float> xyz;
    std::vector<std::uint8_t> labels;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();

    void add(const Eigen::Vector3d& p, Label label = Label::Wall)
    {
        for (const double x : {p.x(), p.y(), p.z()})
            xyz.push_back(static_cast<float>(x));
        labels.push_back(static_cast<std::uint8_t>(label));
    }
    /// A grid on corner + a * u + b * v, points in the middles of squares of about `spacing_m`.
    void face(const Eigen::Vector3d& corner, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
              Label label = Label::Wall, double spacing_m = 0.05)
    {
        const auto m = static_cast<int>(std::lround(u.norm() / spacing_m));
        const auto n = static_cast<int>(std::lround(v.norm() / spacing_m));
        for (int i = 0; i < m; ++i)
            for (int j = 0; j < n; ++j)
                add(corner + (i + 0.5) / m * u + (j + 0.5) / n * v, label);
    }
    [[nodiscard]] CloudView view(bool withLabels = false) const
    {
        return {xyz.data(), xyz.size() / 3, origin, withLabels ? labels.data() : nullptr};
    }
};

/// A folder of its own for a test, removed with all that is in it.
class Folder
{
public:
    Folder()
    {
        static int number = 0;
        m_path = std::filesystem::temp_directory_path() /
                 ("s2b_validation_" + std::to_string(getpid()) + "_" + std::to_string(++number));
        std::filesystem::create_directories(m_path);
    }
    ~Folder() { std::filesystem::remove_all(m_path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::string path() const { return m_path.string(); }
    [[nodiscard]] std::string file(const std::string& name) const { return (m_path / name).string(); }
    [[nodiscard]] std::string write(const std::string& name, const std::string& text) const
    {
        std::ofstream(m_path / name, std::ios::binary) << text;
        return file(name);
    }

private:
    std::filesystem::path m_path;
};

/// The sentence of the Error that `run` throws; fails the test when it throws none.
template <class Run>
std::string errorOf(ErrorCode code, Run run)
{
    try
    {
        run();
    }
    catch (const Error& e)
    {
        return e.code() == code ? e.what() : std::string("another code: ") + e.what();
    }
    return "no error";
}

}  // namespace s2b::test
