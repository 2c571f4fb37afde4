// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/report/sample_report.h"

#include "core/base/random.h"

#include <minizip/unzip.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace s2b::report::testing
{
using namespace validation;
namespace
{

constexpr double kStoreyHeight_m = 3.0;
constexpr double kWallHeight_m = 2.6;

Polygon rectangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double thickness_m)
{
    const Eigen::Vector2d d = (b - a).normalized();
    const Eigen::Vector2d n = Eigen::Vector2d(-d.y(), d.x()) * thickness_m / 2.0;
    return {{a - n, b - n, b + n, a + n}, {}};
}

BimElement wall(const std::string& guid, int storey, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                double thickness_m)
{
    BimElement element;
    element.elementClass = ElementClass::Wall;
    element.guid = guid;
    element.name = "Wall " + guid.substr(18);
    element.type = "IfcWall";
    element.storey = storey;
    element.plan = rectangle(a, b, thickness_m);
    element.low_m = storey * kStoreyHeight_m;
    element.high_m = element.low_m + kWallHeight_m;
    element.axis = WallAxis{a, b, thickness_m};
    return element;
}

BimElement opening(ElementClass elementClass, const std::string& guid, int storey, int host, const Eigen::Vector2d& a,
                   const Eigen::Vector2d& b)
{
    BimElement element = wall(guid, storey, a, b, 0.24);
    element.elementClass = elementClass;
    element.axis.reset();
    element.host = host;
    element.type = elementClass == ElementClass::Door ? "IfcDoor" : "IfcWindow";
    element.name = element.type + " " + guid.substr(18);
    element.high_m = element.low_m + 2.1;
    return element;
}

BimElement slab(const std::string& guid, int storey)
{
    BimElement element;
    element.elementClass = ElementClass::Slab;
    element.guid = guid;
    element.name = "Slab";
    element.type = "IfcSlab";
    element.storey = storey;
    element.plan = rectangle({-0.12, 4.0}, {12.12, 4.0}, 8.24);
    element.high_m = storey * kStoreyHeight_m;
    element.low_m = element.high_m - 0.2;
    return element;
}

/// A GUID of 22 characters that ends in this number.
std::string guid(char kind, int number)
{
    const std::string digits = std::to_string(number);
    return std::string("0") + kind + std::string(20 - digits.size(), '$') + digits;
}

ElementResult pairOf(const Bim& truth, const Bim& result, int t, int r, Outcome outcome)
{
    ElementResult pair;
    pair.elementClass =
        (t >= 0 ? truth.elements[static_cast<std::size_t>(t)] : result.elements[static_cast<std::size_t>(r)])
            .elementClass;
    pair.outcome = outcome;
    pair.truth = t;
    pair.result = r;
    return pair;
}

}  // namespace

SampleReport::SampleReport()
{
    truth.file = "/survey/house/truth.ifc";
    truth.schema = "IFC4";
    truth.origin = {32500100.0, 5600300.0, 120.0};
    truth.storeys = {{"storey-0", "Ground floor", 0.0, true}, {"storey-1", "Upper floor", kStoreyHeight_m, true}};
    result = truth;
    result.file = "/somewhere/else/model.ifc";
    result.storeys[0].name = "Level 0";
    result.storeys[1].name = "Level 1";

    const std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> axes{{{0, 0}, {12, 0}}, {{12, 0}, {12, 8}},
                                                                        {{12, 8}, {0, 8}}, {{0, 8}, {0, 0}},
                                                                        {{5, 0}, {5, 8}},  {{5, 4}, {12, 4}}};
    for (int storey = 0; storey < 2; ++storey)
    {
        for (std::size_t i = 0; i < axes.size(); ++i)
        {
            const int number = storey * 100 + static_cast<int>(i);
            const double thickness_m = i < 4 ? 0.24 : 0.115;
            truth.elements.push_back(wall(guid('T', number), storey, axes[i].first, axes[i].second, thickness_m));
            result.elements.push_back(wall(guid('R', number), storey, axes[i].first, axes[i].second, thickness_m));
        }
        truth.elements.push_back(slab(guid('T', 50 + 100 * storey), storey));
        result.elements.push_back(slab(guid('R', 50 + 100 * storey), storey));
    }
    truth.elements[0].name =
        "<Wand> & \"S\xC3\xBC"
        "d\", au\xC3\x9F"
        "en";  // what a name may hold
    result.elements[0].name = truth.elements[0].name;
    truth.elements.push_back(opening(ElementClass::Door, guid('T', 20), 0, 4, {5, 1.5}, {5, 2.5}));
    result.elements.push_back(opening(ElementClass::Door, guid('R', 20), 0, 4, {5, 1.52}, {5, 2.52}));
    const int door = static_cast<int>(truth.elements.size()) - 1;

    // One of each: missed, not seen, false positive.
    truth.elements.push_back(wall(guid('T', 30), 0, {8, 4}, {8, 8}, 0.115));
    const int missed = static_cast<int>(truth.elements.size()) - 1;
    truth.elements.push_back(wall(guid('T', 31), 1, {2, 4}, {2, 8}, 0.115));
    const int notSeen = static_cast<int>(truth.elements.size()) - 1;
    result.elements.push_back(wall(guid('R', 40), 0, {1.5, 0}, {1.5, 3}, 0.24));
    const int extra = static_cast<int>(result.elements.size()) - 1;

    for (int i = 0; i <= door; ++i)
    {
        ElementResult pair = pairOf(truth, result, i, i, Outcome::Matched);
        pair.iou = 0.9;
        pair.centroid_m = 0.004 + 0.001 * (i % 5);
        if (pair.elementClass == ElementClass::Wall)
        {
            pair.thicknessError_m = i == 2 ? 0.031 : -0.002;
            pair.heightError_m = 0.003;
            pair.axisEnd_m = 0.006;
        }
        validation.elements.push_back(pair);
    }
    validation.elements.push_back(pairOf(truth, result, missed, -1, Outcome::Missed));
    validation.elements.push_back(pairOf(truth, result, notSeen, -1, Outcome::NotSeen));
    validation.elements.push_back(pairOf(truth, result, -1, extra, Outcome::FalsePositive));

    ClassScore walls;
    walls.truthCount = 13;
    walls.resultCount = 13;
    walls.notSeenCount = 1;
    walls.iou = 0.83;
    walls.iouMatched = 0.9;
    walls.at25 = walls.at50 = {12.0 / 13.0, 12.0 / 13.0, 12.0 / 13.0};
    walls.volumetricIou = 0.88;
    walls.centroid_m = 0.006;
    walls.thicknessError_m = 0.002;
    walls.heightError_m = 0.003;
    walls.axisEnd_m = 0.006;
    walls.cornersAt = {{5, {0.95, 0.9, 0.924}}, {10, {1.0, 0.95, 0.974}}, {20, {1.0, 0.95, 0.974}}};
    validation.scores[ElementClass::Wall] = walls;
    ClassScore doors;
    doors.truthCount = doors.resultCount = 1;
    doors.iou = doors.iouMatched = 0.9;
    doors.at25 = doors.at50 = {1.0, 1.0, 1.0};
    validation.scores[ElementClass::Door] = doors;
    ClassScore slabs = doors;
    slabs.truthCount = slabs.resultCount = 2;
    validation.scores[ElementClass::Slab] = slabs;
    validation.meanIou = 0.865;
    validation.storeys = {{0, 0, 0.002}, {1, 1, 0.004}};

    // Points on both faces of the result's walls. Wall 2 bulges: 3 cm in its middle; the others lie within 4 mm.
    CloudDeviation deviation;
    for (std::size_t i = 0; i < result.elements.size(); ++i)
    {
        const BimElement& element = result.elements[i];
        Deviation measured;
        measured.element = static_cast<int>(i);
        const bool isSeen = element.elementClass == ElementClass::Wall || element.elementClass == ElementClass::Slab;
        const Eigen::Vector2d a = element.axis ? element.axis->start : Eigen::Vector2d(0, 4);
        const Eigen::Vector2d d = element.axis ? Eigen::Vector2d(element.axis->end - a) : Eigen::Vector2d(12, 0);
        const double height_m = element.elementClass == ElementClass::Slab ? 7.8 : kWallHeight_m;
        const Eigen::Vector2d n = Eigen::Vector2d(-d.y(), d.x()).normalized();
        double sum = 0.0;
        for (int k = 0; isSeen && k < 12000; ++k)
        {
            const auto share = [&](std::uint64_t stream)
            { return randomShare(i + 1, stream, static_cast<std::uint64_t>(k)); };
            const double s = share(0);
            const double t = share(1);
            double off_m = 0.004 * (2.0 * share(2) - 1.0);
            if (i == 2)
                off_m += 0.03 * std::sin(3.14159 * s) * std::sin(3.14159 * t);
            Eigen::Vector3d p;
            if (element.elementClass == ElementClass::Slab)
            {
                const Eigen::Vector2d q = a + s * d + (t - 0.5) * height_m * n;
                p = {q.x(), q.y(), element.high_m + off_m};
            }
            else
            {
                const double side = k % 2 ? 1.0 : -1.0;
                const Eigen::Vector2d q = a + s * d + side * (element.axis->thickness_m / 2.0 + off_m) * n;
                p = {q.x(), q.y(), element.low_m + t * height_m};
            }
            for (int c = 0; c < 3; ++c)
                xyz.push_back(static_cast<float>(p[c]));
            deviation.distance_m.push_back(static_cast<float>(off_m));
            deviation.element.push_back(static_cast<std::int32_t>(i));
            const auto bin = static_cast<std::size_t>((off_m / params.deviationRange_m + 1.0) / 2.0 * 64.0);
            ++deviation.histogram[bin];
            ++measured.points;
            sum += off_m;
        }
        if (isSeen)
        {
            const bool isBad = i == 2;
            measured.meanAbsolute_m = isBad ? 0.0125 : 0.002;
            measured.meanSigned_m = sum / static_cast<double>(measured.points);
            measured.median_m = isBad ? 0.011 : 0.002;
            measured.rms_m = isBad ? 0.0155 : 0.0023;
            measured.p95_m = isBad ? 0.0282 : 0.0038;
            measured.coverage = 0.94;
            measured.band = isBad ? LoaBand::Loa20 : LoaBand::Loa40;
            measured.verdict = isBad ? Verdict::OutOfTolerance : Verdict::Within;
        }
        deviation.elements.push_back(measured);
    }
    deviation.meanAbsolute_m = {{ElementClass::Wall, 0.0028}, {ElementClass::Slab, 0.002}};
    deviation.wallMeanAbsolute_m = 0.0028;
    validation.cloudToResult = deviation;
    validation.cloudToTruth = deviation;
    validation.cloudToTruth->elements.resize(truth.elements.size());
    validation.cloudToTruth->distance_m.clear();
    validation.cloudToTruth->element.clear();

    // A stray point and one without a distance.
    for (const float z : {1.2F, 1.25F})
    {
        xyz.insert(xyz.end(), {4.0F, 4.0F, z});
        validation.cloudToResult->distance_m.push_back(NAN);
        validation.cloudToResult->element.push_back(-1);
    }
    cloud.xyz = xyz.data();
    cloud.count = xyz.size() / 3;
    cloud.origin = truth.origin;

    building.frame.origin = truth.origin;
    building.diagnostics.push_back(
        {Severity::Warning, "walls", "ThicknessAssumed", "the thickness of wall 7 is assumed", {}, {5.0, 4.0, 0.0}});
}

ReportInput SampleReport::input() const
{
    ReportInput input;
    input.truth = &truth;
    input.result = &result;
    input.validation = &validation;
    input.params = &params;
    input.cloud = hasCloud ? &cloud : nullptr;
    input.building = &building;
    input.cloudName = "scan.laz";
    input.softwareVersion = "Scan to BIM 0.1.0";
    input.parameters = {{"walls.defaultThickness", "0.15"}, {"seed", "1"}};
    return input;
}

void SampleReport::dropPoints()
{
    hasCloud = false;
    validation.cloudToResult.reset();
    validation.cloudToTruth.reset();
}

TestFolder::TestFolder()
{
    std::string pattern = (std::filesystem::temp_directory_path() / "s2b_report_XXXXXX").string();
    if (!::mkdtemp(pattern.data()))
        throw std::runtime_error("no temporary folder");
    m_path = pattern;
}

TestFolder::~TestFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

std::string TestFolder::path(const std::string& name) const
{
    return (name.empty() ? m_path : m_path / name).string();
}

std::string readFile(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::pair<std::string, std::string>> readZip(const std::string& path)
{
    std::vector<std::pair<std::string, std::string>> files;
    const unzFile zip = unzOpen64(path.c_str());
    if (!zip)
        throw std::runtime_error(path + " is no archive");
    for (int next = unzGoToFirstFile(zip); next == UNZ_OK; next = unzGoToNextFile(zip))
    {
        unz_file_info64 info = {};
        std::string name(1000, '\0');
        unzGetCurrentFileInfo64(zip, &info, name.data(), name.size(), nullptr, 0, nullptr, 0);
        name.resize(info.size_filename);
        std::string content(info.uncompressed_size, '\0');
        unzOpenCurrentFile(zip);
        const int read = unzReadCurrentFile(zip, content.data(), static_cast<unsigned>(content.size()));
        // Closing checks the sum over the content.
        if (unzCloseCurrentFile(zip) != UNZ_OK || read != static_cast<int>(content.size()))
            throw std::runtime_error(name + " is damaged");
        files.emplace_back(name, content);
    }
    unzClose(zip);
    return files;
}

}  // namespace s2b::report::testing
