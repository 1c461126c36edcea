#include "clients/chart/chart.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "tests/storage/temporary_directory.hpp"

namespace weft::charts {
namespace {

TEST(DrawnCharts, GridStepsAreRound) {
  EXPECT_DOUBLE_EQ(grid_step(0.0, 1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(grid_step(0.0, 36.0, 8), 5.0);
  EXPECT_DOUBLE_EQ(grid_step(-30.0, 30.0, 5), 20.0);
  EXPECT_DOUBLE_EQ(grid_step(0.0, 0.007, 7), 0.001);
}

TEST(DrawnCharts, NothingToDrawIsDrawnToo) {
  const storage::TemporaryDirectory folder;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Chart> charts = {
      {"empty", "x, m", "y, m", {}, false, {}, false},
      {"one place", "x, m", "y, m", {{"there", {{1.0, 1.0}}, kBlue, Curve::Look::dots, 2.0}}, true, {}, false},
      {"gaps",
       "x, m",
       "y, m",
       {{"", {{0.0, none}, {1.0, 2.0}, {none, 1.0}}, kInk, Curve::Look::steps, 1.0}},
       false,
       {},
       true},
  };
  ASSERT_TRUE(draw_charts("title", "about", charts, 2, folder.path() / "c.png").has_value());
  EXPECT_GT(std::filesystem::file_size(folder.path() / "c.png"), 1'000U);
  const auto nowhere = draw_charts("title", "about", charts, 2, folder.path() / "none" / "c.png");
  ASSERT_FALSE(nowhere.has_value());
  EXPECT_NE(nowhere.error().message.find("none/c.png"), std::string::npos) << nowhere.error().message;
}

TEST(DrawnCharts, AFileThatEndsInSvgIsOne) {
  const storage::TemporaryDirectory folder;
  const std::vector<Chart> charts = {
      {"one", "x, m", "y, m", {{"there", {{1.0, 1.0}, {2.0, 3.0}}}}, false, {}, false}};
  ASSERT_TRUE(draw_charts("title", "about", charts, 1, folder.path() / "c.svg", {900.0, 300.0}).has_value());
  std::ifstream in(folder.path() / "c.svg");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("<svg"), std::string::npos);
  EXPECT_NE(text.find("width=\"920"), std::string::npos) << text.substr(0, 300);
  EXPECT_FALSE(draw_charts("title", "about", charts, 1, folder.path() / "none" / "c.svg").has_value());
}

}  // namespace
}  // namespace weft::charts
