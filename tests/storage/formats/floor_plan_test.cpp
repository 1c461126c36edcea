#include "storage/formats/floor_plan.hpp"

#include <gtest/gtest.h>

namespace weft::formats {
namespace {

const std::string kRest = "origin: [1.0, -2.0, 0.5]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n";
const std::string kMapFile = "image: a.pgm\nresolution: 0.1\n" + kRest;

MapServerFile described(const std::string& text) {
  auto read = read_map_server(text, "a.yaml");
  EXPECT_TRUE(read.has_value()) << (read ? "" : read.error().message);
  return read ? read->value : MapServerFile{};
}

TEST(MapServer, ReadsItsKeysAndListsOthers) {
  const auto read = read_map_server(kMapFile + "mode: scale\nshade: 3\n", "a.yaml");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value.image, "a.pgm");
  EXPECT_EQ(read->value.resolution_m, 0.1);
  EXPECT_EQ(read->value.origin, (Pose2{1.0, -2.0, 0.5}));
  EXPECT_EQ(read->value.mode, MapServerFile::Mode::scale);
  EXPECT_EQ(read->not_understood, (std::vector<NotUnderstood>{{"shade", 8, 1}}));
  EXPECT_EQ(described(kMapFile).mode, MapServerFile::Mode::trinary);
}

TEST(MapServer, EveryBooleanOfYamlIsTaken) {
  const auto negated = [](const std::string& word) {
    std::string text = kMapFile;
    return described(text.replace(text.find("negate: 0"), 9, "negate: " + word)).negate;
  };
  for (const char* const word : {"1", "true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON", "y", "Y"}) {
    EXPECT_TRUE(negated(word)) << word;
  }
  for (const char* const word : {"0", "false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF", "n", "N"}) {
    EXPECT_FALSE(negated(word)) << word;
  }
}

TEST(MapServer, WhatIsWrongIsSaidWithItsLine) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"", "a.yaml:1: a map_server file is a list of 'key: value'"},
      {"- 1\n", "a.yaml:1: a map_server file is a list of 'key: value'"},
      {"image: a.pgm\n" + kRest, "a.yaml:1: the key resolution is missing"},
      {"image: a.pgm\nresolution: -1\n" + kRest, "a.yaml:2: resolution must be a number in [1e-06, 100]"},
      {"image: a.pgm\nresolution: fine\n" + kRest, "a.yaml:2: resolution must be a number in [1e-06, 100]"},
      {"image: []\nresolution: 1\n" + kRest, "a.yaml:1: image must be the name of a file"},
      {kMapFile + "mode: grey\n", "a.yaml:7: mode must be trinary, scale or raw"},
      {kMapFile + "image: b.pgm\n", "a.yaml:7: image stands there a second time"},
      {"image: a\nresolution: 1\norigin: [1, 2]\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0\n",
       "a.yaml:3: origin must be [x, y, heading] of the lower left pixel, metres and radians"},
      {"image: a\nresolution: 1\norigin: [1, 2, nan]\nnegate: 0\noccupied_thresh: 1\nfree_thresh: 0\n",
       "a.yaml:3: origin's heading must be a number in [-1e+06, 1e+06]"},
      {"image: a\nresolution: 1\norigin: [1, 2, 0]\nnegate: 2\noccupied_thresh: 1\nfree_thresh: 0\n",
       "a.yaml:4: negate must be 0, 1, false or true"},
      {"image: a\nresolution: 1\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.2\nfree_thresh: 0.2\n",
       "a.yaml:1: free_thresh is not below occupied_thresh"}};
  for (const auto& [text, message] : table) {
    const auto read = read_map_server(text, "a.yaml");
    ASSERT_FALSE(read.has_value()) << message;
    EXPECT_EQ(read.error().message, message);
  }
  const auto broken = read_map_server("image: [a\nresolution", "a.yaml");
  ASSERT_FALSE(broken.has_value());
  EXPECT_EQ(broken.error().message.rfind("a.yaml:2: no YAML: ", 0), 0U) << broken.error().message;
}

/// Returns the cells of one row of pixels with white 255.
std::vector<std::int8_t> cells(const std::string& text, const std::vector<std::uint16_t>& pixels) {
  const GreyImage image{static_cast<std::uint32_t>(pixels.size()), 1, 255, pixels};
  return floor_plan_from(described(text), image).cells;
}

TEST(FloorPlan, PixelsMeanWhatTheModeSays) {
  constexpr std::int8_t kUnknown = FloorPlan::kUnknown;
  using Cells = std::vector<std::int8_t>;
  EXPECT_EQ(cells(kMapFile, {0, 254, 205, 127}), (Cells{100, 0, 0, kUnknown}));
  std::string negated = kMapFile;
  negated.replace(negated.find("negate: 0"), 9, "negate: 1");
  EXPECT_EQ(cells(negated, {0, 254, 127}), (Cells{0, 100, kUnknown}));
  // p = 1 - 140.25 / 255 = 0.45 lies half-way between 0.25 and 0.65.
  EXPECT_EQ(cells(kMapFile + "mode: scale\n", {0, 255, 140}), (Cells{100, 0, 50}));
  EXPECT_EQ(cells(kMapFile + "mode: raw\n", {0, 42, 100, 101, 255}), (Cells{0, 42, 100, kUnknown, kUnknown}));
}

TEST(FloorPlan, WhatIsTransparentIsDarkerOrUnknown) {
  using Cells = std::vector<std::int8_t>;
  const GreyImage image{3, 1, 255, {255, 255, 0}, {255, 0, 255}};
  // p = 1 - (3 * 255 + 0) / (4 * 255) = 0.25 is not below 0.25; p = 1 - (0 + 255) / (4 * 255) = 0.75.
  EXPECT_EQ(floor_plan_from(described(kMapFile), image).cells, (Cells{0, FloorPlan::kUnknown, 100}));
  EXPECT_EQ(floor_plan_from(described(kMapFile + "mode: scale\n"), image).cells,
            (Cells{0, FloorPlan::kUnknown, 100}));
}

TEST(FloorPlan, TheBottomRowOfTheImageComesFirst) {
  const GreyImage image{1, 3, 255, {0, 127, 255}};
  const FloorPlan plan = floor_plan_from(described(kMapFile), image);
  EXPECT_EQ(plan.cells, (std::vector<std::int8_t>{0, FloorPlan::kUnknown, 100}));
  EXPECT_EQ(plan.height, 3U);
  EXPECT_EQ(plan.cell_m, 0.1);
  EXPECT_EQ(plan.plan_from_grid, (Pose2{1.0, -2.0, 0.5}));
}

}  // namespace
}  // namespace weft::formats
