// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/laz_reader.h"

#include "core/base/error.h"

#include <laszip_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace s2b
{

PointCloud readLaz(const std::string& path, std::vector<std::array<std::uint8_t, 3>>* colours,
                   std::vector<std::uint16_t>* sources)
{
    laszip_POINTER reader = nullptr;
    if (laszip_create(&reader))
        throw Error(ErrorCode::Internal, "LASzip could not be started");
    const auto guard = std::unique_ptr<void, void (*)(void*)>(reader, [](void* r) { laszip_destroy(r); });
    const auto check = [&](laszip_I32 failed)
    {
        if (!failed)
            return;
        laszip_CHAR* text = nullptr;
        laszip_get_error(reader, &text);
        throw Error(ErrorCode::BadFile, path + " can't be read as LAS or LAZ: " + (text ? text : "unknown error"));
    };
    laszip_BOOL compressed = 0;
    check(laszip_open_reader(reader, path.c_str(), &compressed));
    laszip_header_struct* header = nullptr;
    check(laszip_get_header_pointer(reader, &header));
    const std::uint64_t count =
        header->number_of_point_records ? header->number_of_point_records : header->extended_number_of_point_records;
    laszip_point_struct* point = nullptr;
    check(laszip_get_point_pointer(reader, &point));
    PointCloud cloud;
    cloud.points.reserve(count);
    cloud.labels.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
    {
        check(laszip_read_point(reader));
        std::array<laszip_F64, 3> c{};
        check(laszip_get_coordinates(reader, c.data()));
        if (i == 0 && std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])}) > 1e4)
            cloud.origin = (Eigen::Vector3d(c[0], c[1], c[2]) / 100).array().round() * 100;
        cloud.points.emplace_back((Eigen::Vector3d(c[0], c[1], c[2]) - cloud.origin).cast<float>());
        const unsigned code = header->point_data_format >= 6 ? point->extended_classification : point->classification;
        cloud.labels.push_back(code < kLabelCount ? static_cast<Label>(code) : Label::Unassigned);
        if (sources)
            sources->push_back(point->point_source_ID);
        if (colours)
            colours->push_back({static_cast<std::uint8_t>(point->rgb[0] >> 8),
                                static_cast<std::uint8_t>(point->rgb[1] >> 8),
                                static_cast<std::uint8_t>(point->rgb[2] >> 8)});
    }
    check(laszip_close_reader(reader));
    return cloud;
}

}  // namespace s2b
