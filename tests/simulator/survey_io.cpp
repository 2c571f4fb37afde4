// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simulator/survey_io.h"

#include "core/base/error.h"
#include "tests/simulator/output_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace s2b::sim
{

namespace
{

constexpr std::size_t kBlock = 1U << 16;  ///< points that are formatted before they are written

template <class T>
char* put(char* to, T value)
{
    std::memcpy(to, &value, sizeof(T));
    return to + sizeof(T);
}

}  // namespace

void writePly(const Survey& survey, const std::string& path)
{
    OutputFile file(path);
    const bool isFar = survey.origin != Eigen::Vector3d::Zero();
    const std::string type = isFar ? "double" : "float";
    std::ofstream out(file.temporary(), std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << survey.size() << '\n';
    for (const char* name : {"x", "y", "z"})
        out << "property " << type << ' ' << name << '\n';
    out << "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float "
           "scalar_Classification\nend_header\n";
    std::vector<char> block(kBlock * 32);
    for (std::size_t begin = 0; begin < survey.size(); begin += kBlock)
    {
        char* to = block.data();
        for (std::size_t i = begin; i < std::min(survey.size(), begin + kBlock); ++i)
        {
            for (int k = 0; k < 3; ++k)
                to = isFar ? put(to, survey.origin[k] + static_cast<double>(survey.points[i][k]))
                           : put(to, survey.points[i][k]);
            for (const std::uint8_t c : survey.colours[i])
                to = put(to, c);
            to = put(to, static_cast<float>(survey.labels[i]));
        }
        out.write(block.data(), to - block.data());
    }
    out.close();
    if (!out)
        file.fail("the disk may be full");
    file.commit();
}

void writeXyz(const Survey& survey, const std::string& path)
{
    OutputFile file(path);
    std::ofstream out(file.temporary(), std::ios::binary);
    std::vector<char> block(kBlock * 96);
    for (std::size_t begin = 0; begin < survey.size(); begin += kBlock)
    {
        char* to = block.data();
        char* const end = block.data() + block.size();
        for (std::size_t i = begin; i < std::min(survey.size(), begin + kBlock); ++i)
        {
            for (int k = 0; k < 3; ++k)
            {
                to = std::to_chars(to, end, survey.origin[k] + static_cast<double>(survey.points[i][k]),
                                   std::chars_format::fixed, 4)
                         .ptr;
                *to++ = ' ';
            }
            to = std::to_chars(to, end, static_cast<int>(survey.labels[i])).ptr;
            *to++ = '\n';
        }
        out.write(block.data(), to - block.data());
    }
    out.close();
    if (!out)
        file.fail("the disk may be full");
    file.commit();
}

void writeSurvey(const Survey& survey, const std::string& path)
{
    const std::string extension = std::filesystem::path(path).extension().string();
    if (extension == ".laz" || extension == ".las")
        writeLas(survey, path);
    else if (extension == ".ply")
        writePly(survey, path);
    else if (extension == ".xyz" || extension == ".txt")
        writeXyz(survey, path);
    else
        checkWritable(path, true);
}

void checkWritable(const std::string& path, bool isSurvey)
{
    static constexpr std::array kKnown{".laz", ".las", ".ply", ".xyz", ".txt"};
    const std::string extension = std::filesystem::path(path).extension().string();
    if (isSurvey && std::find(kKnown.begin(), kKnown.end(), extension) == kKnown.end())
        throw Error(ErrorCode::BadParameter,
                    "'" + path + "' has no known extension: use .laz, .las, .ply, .xyz or .txt");
    const OutputFile probe(path);
}

}  // namespace s2b::sim
