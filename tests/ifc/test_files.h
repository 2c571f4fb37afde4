// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/building.h"
#include "ifc/ifc_reader.h"
#include "ifc/ifc_writer.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace s2b::test
{

/// A folder of its own for each test, removed with all that is in it.
class TestFolder
{
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    [[nodiscard]] std::string file(std::string_view name) const { return (m_path / name).string(); }
    [[nodiscard]] std::size_t fileCount() const;

private:
    std::filesystem::path m_path;
};

[[nodiscard]] std::string readText(const std::string& path);
void writeText(const std::string& path, std::string_view text);

/// Writes and reads back.
[[nodiscard]] ifc::IfcModel roundTrip(const Building& building, const ifc::WriteOptions& options = {},
                                      const ifc::ReadOptions& readOptions = {});

/// Of a closed mesh.
[[nodiscard]] double volumeOf(const ifc::MeshElement& element);

struct Box
{
    Eigen::Vector3d low, high;
};
[[nodiscard]] Box boxOf(const ifc::MeshElement& element);

/// The element of that type and name. Fails the test when there is none.
[[nodiscard]] const ifc::MeshElement& elementOf(const ifc::IfcModel& model, std::string_view type,
                                                std::string_view name);

}  // namespace s2b::test
