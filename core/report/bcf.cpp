// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/bcf.h"

#include "core/report/template.h"
#include "core/report/text.h"
#include "core/report/zip.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace s2b::report
{
using namespace validation;
namespace
{

constexpr const char* kAuthor = "Scan to BIM for CloudCompare";
constexpr double kFieldOfView_deg = 60.0;  // BCF 2.1 allows 45 to 60
constexpr int kDecimals = 6;

constexpr const char* kVersion =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Version VersionId=\"2.1\">\n  "
    "<DetailedVersion>2.1</DetailedVersion>\n"
    "</Version>\n";

bool isIfcGuid(const std::string& guid)
{
    return guid.size() == 22 &&
           guid.find_first_not_of("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$") ==
               std::string::npos;
}

std::string typeOf(const Row& row)
{
    switch (row.pair.outcome)
    {
        case Outcome::Missed:
            return "Missing element";
        case Outcome::FalsePositive:
            return "Element without a counterpart";
        case Outcome::Matched:
        case Outcome::NotSeen:
        case Outcome::Excused:
            break;
    }
    return "Deviation";
}

std::string titleOf(const Row& row)
{
    std::string title = className(row.pair.elementClass);
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
    if (!row.name.empty())
        title += " \"" + row.name + "\"";
    if (row.pair.outcome == Outcome::Missed)
        return title + " is missing";
    if (row.pair.outcome == Outcome::FalsePositive)
        return title + " has no counterpart in the truth";
    return title + " deviates by " + (row.error_m ? millimetres(*row.error_m) + " mm" : std::string("too much"));
}

std::string descriptionOf(const Row& row)
{
    std::string text = row.storey.empty() ? "" : row.storey + ". ";
    text += "No. " + std::to_string(row.number) + " in the report: " + row.reason + ".";
    const auto add = [&](const char* what, const std::optional<double>& value)
    {
        if (value)
            text += std::string("\n") + what + ": " + millimetres(*value, true) + " mm";
    };
    add("Thickness, result - truth", row.pair.thicknessError_m);
    add("Height, result - truth", row.pair.heightError_m);
    if (row.pair.axisEnd_m)
        text += "\nEnd of the axis: " + millimetres(*row.pair.axisEnd_m) + " mm off";
    if (row.toResult && row.toResult->points > 0)
        text += "\nPoints: " + std::to_string(row.toResult->points) + ", mean " +
                millimetres(row.toResult->meanSigned_m, true) + " mm, RMS " + millimetres(row.toResult->rms_m) +
                " mm, 95 % within " + millimetres(row.toResult->p95_m) + " mm, coverage " +
                percent(row.toResult->coverage);
    return text;
}

/// The box of the element, in world coordinates.
Eigen::AlignedBox3d worldBox(const Row& row, const Scene& scene)
{
    const BimElement& element = row.element();
    Eigen::AlignedBox3d box;
    for (const Polygon& outline : outlinesOf(element, Eigen::Vector3d::Zero()))
    {
        for (const Eigen::Vector2d& p : outline.outer)
        {
            box.extend(Eigen::Vector3d(p.x(), p.y(), element.low_m));
            box.extend(Eigen::Vector3d(p.x(), p.y(), element.high_m));
        }
    }
    if (box.isEmpty())
        box.extend(Eigen::Vector3d(0, 0, element.low_m));
    box.translate(scene.base + scene.shiftOf(row));
    return box;
}

void setVector(Fields& fields, const std::string& name, const Eigen::Vector3d& v)
{
    fields.set(name + "_X", plainNumber(v.x(), kDecimals));
    fields.set(name + "_Y", plainNumber(v.y(), kDecimals));
    fields.set(name + "_Z", plainNumber(v.z(), kDecimals));
}

/// A view from the side of the element and half from above, so far off that a ball around it fits.
std::string viewpoint(const Row& row, const Scene& scene, const std::string& guid)
{
    const Eigen::AlignedBox3d box = worldBox(row, scene);
    const double radius_m = std::max(0.5, box.sizes().norm() / 2.0);
    constexpr double kSpare = 1.15;
    const double distance_m = kSpare * radius_m / std::sin(kFieldOfView_deg / 2.0 * std::numbers::pi / 180.0);

    Eigen::Vector2d side =
        box.sizes().x() >= box.sizes().y() ? Eigen::Vector2d(-0.35, -1.0) : Eigen::Vector2d(1.0, -0.35);
    if (const auto& axis = row.element().axis; axis && (axis->end - axis->start).norm() > 0.0)
    {
        const Eigen::Vector2d along = (axis->end - axis->start).normalized();
        side = Eigen::Vector2d(-along.y(), along.x()) - 0.35 * along;
    }
    const Eigen::Vector3d back = Eigen::Vector3d(side.normalized().x(), side.normalized().y(), 0.75).normalized();
    const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(back).normalized();

    Fields fields;
    fields.set("VIEWPOINT", guid);
    setVector(fields, "EYE", box.center() + distance_m * back);
    setVector(fields, "DIRECTION", -back);
    setVector(fields, "UP", back.cross(right));
    fields.set("FIELD_OF_VIEW", plainNumber(kFieldOfView_deg, 1));
    Fields selection;
    for (const BimElement* element : {row.result, row.truth})
    {
        if (element && isIfcGuid(element->guid))
            selection.add("COMPONENT").set("GUID", element->guid);
    }
    if (!selection.sections.empty())
        fields.add("SELECTION") = selection;
    return fillTemplate(kViewpointTemplate, fields);
}

std::string markup(const Row& row, const ReportInput& input, const std::string& topic, const std::string& viewpointGuid)
{
    Fields fields;
    fields.set("TOPIC", topic);
    fields.set("VIEWPOINT", viewpointGuid);
    fields.set("TYPE", typeOf(row));
    fields.set("TITLE", titleOf(row));
    fields.set("PRIORITY", row.pair.outcome == Outcome::Matched ? "Normal" : "Major");
    fields.set("INDEX", std::to_string(row.number));
    fields.set("DATE", cleanText(input.timestamp));
    fields.set("AUTHOR", kAuthor);
    fields.set("DESCRIPTION", descriptionOf(row));
    fields.add("LABEL").set("TEXT", className(row.pair.elementClass));
    for (const Bim* bim : {input.result, input.truth})
    {
        if (!bim)
            continue;
        Fields& file = fields.add("FILE");
        file.set("NAME", fileName(bim->file));
        file.set("DATE", cleanText(input.timestamp));
    }
    return fillTemplate(kMarkupTemplate, fields);
}

}  // namespace

std::string makeBcf(const ReportInput& input, const Scene& scene, const std::map<std::size_t, std::string>& snapshots)
{
    const std::string space =
        fileName(input.result->file) + "/" + (input.truth ? fileName(input.truth->file) : std::string()) + "/";
    std::vector<std::pair<std::string, std::string>> files{{"bcf.version", kVersion}};
    std::map<std::string, int> copiesOf;
    for (std::size_t i = 0; i < scene.rows.size(); ++i)
    {
        const Row& row = scene.rows[i];
        if (row.verdict != Verdict::OutOfTolerance)
            continue;
        // Some files have several elements of the same GUID.
        std::string name = space + outcomeName(row.pair.outcome) + "/" + row.id;
        if (const int copies = copiesOf[name]++)
            name += "/" + std::to_string(copies);
        const std::string topic = nameUuid(name);
        const std::string view = nameUuid(name + "/viewpoint");
        files.emplace_back(topic + "/markup.bcf", markup(row, input, topic, view));
        files.emplace_back(topic + "/viewpoint.bcfv", viewpoint(row, scene, view));
        if (const auto snapshot = snapshots.find(i); snapshot != snapshots.end())
            files.emplace_back(topic + "/snapshot.png", snapshot->second);
    }
    return makeZip(files);
}

}  // namespace s2b::report
