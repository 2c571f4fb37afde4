// SPDX-License-Identifier: GPL-3.0-or-later
/// A validation laid out by hand: a house of two storeys at world coordinates with one element of every kind of
/// outcome, and points on its walls whose distances are known.
#pragma once

#include "core/report/report.h"

#include <filesystem>
#include <string>
#include <vector>

namespace s2b::report::testing
{

struct SampleReport
{
    SampleReport();
    SampleReport(const SampleReport&) = delete;
    SampleReport& operator=(const SampleReport&) = delete;

    [[nodiscard]] ReportInput input() const;
    /// What is left when there are no points.
    void dropPoints();

    validation::Bim truth;
    validation::Bim result;
    validation::Validation validation;
    validation::ValidationParams params;
    Building building;
    std::vector<float> xyz;
    CloudView cloud;
    bool hasCloud = true;
};

/// A folder of its own, removed at the end.
class TestFolder
{
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    [[nodiscard]] std::string path(const std::string& name = {}) const;

private:
    std::filesystem::path m_path;
};

[[nodiscard]] std::string readFile(const std::string& path);

/// Files of a ZIP archive by name.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> readZip(const std::string& path);

}  // namespace s2b::report::testing
