#include "clients/cli/chart.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "tests/storage/temporary_directory.hpp"

namespace weft::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(DrawnChart, GridStepsAreRound) {
  EXPECT_DOUBLE_EQ(grid_step(0.0, 1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(grid_step(0.0, 36.0, 8), 5.0);
  EXPECT_DOUBLE_EQ(grid_step(-30.0, 30.0, 5), 20.0);
  EXPECT_DOUBLE_EQ(grid_step(0.0, 0.007, 7), 0.001);
}

TEST(DrawnChart, NothingToDrawIsDrawnToo) {
  const storage::TemporaryDirectory folder;
  const Chart empty{"title", "about", "x, m", "y, m", {}, {}, {}};
  Chart gaps{"title", "about", "x, m", "y, m", {3.0, 3.0}, {}, {{"gaps", {{0.0, kNone}, {1.0, 2.0}, {kNone, 1.0}}}}};
  for (const Chart& chart : {empty, gaps}) {
    const std::string file = folder.path() / "c.png";
    const Result<void> drawn = draw_chart(chart, file, 900.0, 300.0);
    ASSERT_TRUE(drawn.has_value()) << drawn.error().message;
    EXPECT_GT(std::filesystem::file_size(file), 1'000U);
  }
}

TEST(DrawnChart, AFileThatEndsInSvgIsOne) {
  const storage::TemporaryDirectory folder;
  const Chart chart{"one", "about", "x, m", "y, m", {0.0, 2.0}, {0.0, 3.0}, {{"there", {{1.0, 1.0}, {2.0, 3.0}}}}};
  ASSERT_TRUE(draw_chart(chart, folder.path() / "c.svg", 900.0, 300.0).has_value());
  std::ifstream in(folder.path() / "c.svg");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("<svg"), std::string::npos);
  EXPECT_NE(text.find("width=\"900"), std::string::npos) << text.substr(0, 300);
}

}  // namespace
}  // namespace weft::cli
