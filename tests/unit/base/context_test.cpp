// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/context.h"

#include <gtest/gtest.h>

#include <string>

namespace s2b
{
namespace
{

TEST(Context, DoesNothingWithoutListeners)
{
    const Context context;
    EXPECT_NO_THROW(context.report("Levels", 0.5));
    EXPECT_NO_THROW(context.say(LogLevel::Error, "nobody listens"));
    EXPECT_NO_THROW(context.checkCancelled());
}

TEST(Context, PassesTextAndFractionOn)
{
    Context context;
    std::string said;
    double fraction = -1;
    context.progress = [&](std::string_view text, double f)
    {
        said = text;
        fraction = f;
    };
    context.report("Levels", 0.5);
    EXPECT_EQ(said, "Levels");
    EXPECT_EQ(fraction, 0.5);
}

TEST(Context, ReportsNothingMoreOnceCancelled)
{
    Context context;
    std::stop_source stop;
    context.cancel = stop.get_token();
    int reports = 0;
    context.progress = [&](std::string_view, double) { ++reports; };
    stop.request_stop();
    EXPECT_THROW(context.report("Levels", 0.5), Cancelled);
    EXPECT_THROW(context.checkCancelled(), Cancelled);
    EXPECT_EQ(reports, 0);
}

}  // namespace
}  // namespace s2b
