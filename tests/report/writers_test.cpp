// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/report/sample_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace s2b::report::testing
{
namespace
{
TEST(Report, Look)
{
    const char* folder = std::getenv("S2B_REPORT_LOOK");
    if (!folder)
        GTEST_SKIP();
    SampleReport sample;
    writeReport(sample.input(), folder, {});
}
}  // namespace
}  // namespace s2b::report::testing
