// SPDX-License-Identifier: GPL-3.0-or-later
#include "test_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace s2b::test
{

TestFolder::TestFolder()
{
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
        std::string("s2b_") + info->test_suite_name() + '_' + info->name() + '_' + std::to_string(::getpid());
    for (char& c : name)
        if (c == '/')
            c = '_';
    m_path = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove_all(m_path);
    std::filesystem::create_directories(m_path);
}

TestFolder::~TestFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

std::size_t TestFolder::fileCount() const
{
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(m_path))
        ++count;
    return count;
}

std::string readText(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return std::move(text).str();
}

void writeText(const std::string& path, std::string_view text)
{
    std::ofstream(path, std::ios::binary) << text;
}

ifc::IfcModel roundTrip(const Building& building, const ifc::WriteOptions& options, const ifc::ReadOptions& readOptions)
{
    const TestFolder folder;
    ifc::writeIfc(building, folder.file("model.ifc"), options);
    return ifc::readIfc(folder.file("model.ifc"), readOptions);
}

double volumeOf(const ifc::MeshElement& element)
{
    double six = 0.0;
    const Eigen::Vector3d& origin = element.vertices.front();
    for (const auto& t : element.triangles)
        six += (element.vertices[t[0]] - origin)
                   .dot((element.vertices[t[1]] - origin).cross(element.vertices[t[2]] - origin));
    return six / 6.0;
}

Box boxOf(const ifc::MeshElement& element)
{
    Box box = {element.vertices.front(), element.vertices.front()};
    for (const Eigen::Vector3d& v : element.vertices)
    {
        box.low = box.low.cwiseMin(v);
        box.high = box.high.cwiseMax(v);
    }
    return box;
}

const ifc::MeshElement& elementOf(const ifc::IfcModel& model, std::string_view type, std::string_view name)
{
    for (const ifc::MeshElement& element : model.elements)
        if (element.type == type && element.name == name)
            return element;
    throw std::runtime_error("no " + std::string(type) + " \"" + std::string(name) + "\" in the file");
}

}  // namespace s2b::test
