#include "app/progress_bar.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace asos {
namespace {

Progress progress_at(double fraction, double seconds_left) {
  return {.fraction = fraction, .seconds_left = seconds_left};
}

TEST(ProgressBar, ShowsShareAndTimeLeft) {
  EXPECT_EQ(progress_line(progress_at(0.5, 12), 79),
            "[####################....................]  50 %  0:12 left");
}

TEST(ProgressBar, NamesNoTimeBeforeThereIsAnEstimate) {
  EXPECT_EQ(progress_line(progress_at(0.0, -1), 79),
            "[........................................]   0 %");
}

TEST(ProgressBar, HundredPercentIsTheEnd) {
  EXPECT_NE(progress_line(progress_at(0.9999, 0), 79).find(" 99 %"), std::string::npos);
  EXPECT_NE(progress_line(progress_at(1.0, 0), 79).find("100 %"), std::string::npos);
}

TEST(ProgressBar, FitsItsColumns) {
  for (int columns = -1; columns < 100; ++columns)
    EXPECT_LE(static_cast<int>(progress_line(progress_at(0.7, 4000), columns).size()),
              std::max(columns, 0))
        << columns;
}

TEST(ProgressBar, ClockTimesRoundUp) {
  EXPECT_EQ(clock_time(0), "0:00");
  EXPECT_EQ(clock_time(6.2), "0:07");
  EXPECT_EQ(clock_time(750), "12:30");
  EXPECT_EQ(clock_time(3723), "1:02:03");
  EXPECT_EQ(clock_time(std::numeric_limits<double>::infinity()), "100000:00:00");
}

TEST(ProgressBar, DrawsOnlyOnTerminalsAndWipesBehindItself) {
  std::ostringstream plain;
  {
    ProgressBar bar(plain, false);
    bar.say("Loading");
    bar.show(progress_at(0.5, 1));
  }
  EXPECT_EQ(plain.str(), "");

  std::ostringstream terminal;
  {
    ProgressBar bar(terminal, true);
    bar.say("Loading");
    bar.say("End");
  }
  EXPECT_EQ(terminal.str(), "\rLoading\rEnd    \r   \r");
}

}  // namespace
}  // namespace asos
