// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/simulator/output_file.h"
#include "tests/simulator/survey_io.h"

#include <laszip/laszip_api.h>

#include <cmath>
#include <cstring>
#include <filesystem>

namespace s2b::sim
{

namespace
{

constexpr double kScale_m = 0.001;

class LaszipWriter
{
public:
    explicit LaszipWriter(const OutputFile& file) : m_file(file)
    {
        if (laszip_create(&m_handle) != 0)
            file.fail("LASzip could not be started");
    }
    ~LaszipWriter() { laszip_destroy(m_handle); }
    LaszipWriter(const LaszipWriter&) = delete;
    LaszipWriter& operator=(const LaszipWriter&) = delete;

    operator laszip_POINTER() const { return m_handle; }
    void check(laszip_I32 failed) const
    {
        if (failed == 0)
            return;
        laszip_CHAR* text = nullptr;
        laszip_get_error(m_handle, &text);
        m_file.fail(text != nullptr ? text : "LASzip gives no reason");
    }

private:
    const OutputFile& m_file;
    laszip_POINTER m_handle = nullptr;
};

}  // namespace

void writeLas(const Survey& survey, const std::string& path)
{
    if (survey.points.empty())
        throw Error(ErrorCode::EmptyCloud, "there is no point to write to '" + path + "'");
    OutputFile file(path);
    LaszipWriter laszip(file);
    laszip_header_struct* header = nullptr;
    laszip.check(laszip_get_header_pointer(laszip, &header));

    // Whole metres as offset: the coordinates' own digits are then the millimetres that a reader sees.
    const Eigen::Vector3d offset = survey.origin.array().floor();
    const Eigen::Vector3d shift = survey.origin - offset;
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e300);
    Eigen::Vector3d high = -low;
    for (const Eigen::Vector3f& p : survey.points)
    {
        low = low.cwiseMin(p.cast<double>());
        high = high.cwiseMax(p.cast<double>());
    }
    constexpr double kReach_m = 2.0e6;  // of 32-bit millimetres
    if (!(low.minCoeff() > -kReach_m && high.maxCoeff() < kReach_m))
        throw Error(ErrorCode::BadCoordinates, "points of '" + path + "' are further than 2000 km from their origin");
    const auto toMillimetres = [&](double local, int axis)
    { return static_cast<laszip_I32>(std::lround((local + shift[axis]) / kScale_m)); };
    const auto world = [&](double local, int axis) { return offset[axis] + toMillimetres(local, axis) * kScale_m; };

    header->version_major = 1;
    header->version_minor = 4;
    header->header_size = 375;
    header->offset_to_point_data = 375;
    header->point_data_format = 7;
    header->point_data_record_length = 36;
    header->global_encoding = 16;  // coordinate system as WKT, as point formats from 6 on demand; there is none
    std::strncpy(header->system_identifier, "simulated", sizeof(header->system_identifier) - 1);
    std::strncpy(header->generating_software, "s2b_survey", sizeof(header->generating_software) - 1);
    header->file_creation_day = 1;
    header->file_creation_year = 2000;  // fixed, so that the bytes are
    header->x_scale_factor = header->y_scale_factor = header->z_scale_factor = kScale_m;
    header->x_offset = offset.x();
    header->y_offset = offset.y();
    header->z_offset = offset.z();
    header->min_x = world(low.x(), 0);
    header->max_x = world(high.x(), 0);
    header->min_y = world(low.y(), 1);
    header->max_y = world(high.y(), 1);
    header->min_z = world(low.z(), 2);
    header->max_z = world(high.z(), 2);
    header->number_of_point_records = 0;  // the old counter stays empty from point format 6 on
    header->extended_number_of_point_records = survey.size();
    header->extended_number_of_points_by_return[0] = survey.size();

    laszip.check(laszip_preserve_generating_software(laszip, 1));
    laszip.check(laszip_request_native_extension(laszip, 1));
    const bool isCompressed = std::filesystem::path(path).extension() == ".laz";
    laszip.check(laszip_open_writer(laszip, file.temporary().c_str(), isCompressed ? 1 : 0));
    laszip_point_struct* point = nullptr;
    laszip.check(laszip_get_point_pointer(laszip, &point));
    point->extended_return_number = 1;
    point->extended_number_of_returns = 1;
    point->extended_point_type = 1;
    for (std::size_t i = 0; i < survey.size(); ++i)
    {
        point->X = toMillimetres(static_cast<double>(survey.points[i].x()), 0);
        point->Y = toMillimetres(static_cast<double>(survey.points[i].y()), 1);
        point->Z = toMillimetres(static_cast<double>(survey.points[i].z()), 2);
        const auto code = static_cast<laszip_U8>(survey.labels[i]);
        point->extended_classification = code;
        point->classification = code & 31U;
        for (std::size_t c = 0; c < 3; ++c)
            point->rgb[c] = static_cast<laszip_U16>(survey.colours[i][c] * 257U);
        point->point_source_ID = static_cast<laszip_U16>(survey.stations[i] + 1U);
        laszip.check(laszip_write_point(laszip));
    }
    laszip.check(laszip_close_writer(laszip));
    file.commit();
}

}  // namespace s2b::sim
