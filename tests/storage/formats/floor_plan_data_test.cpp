#include <gtest/gtest.h>

#include <algorithm>

#include "storage/formats/floor_plan.hpp"
#include "storage/formats/pgm.hpp"
#include "tests/storage/formats/data_files.hpp"

namespace weft::formats::test {
namespace {

TEST(PgmFiles, EachIsReadAndWrittenTheSame) {
  const auto data = data_folder();
  if (!data) GTEST_SKIP() << no_data("images");
  const auto files = files_that_end(*data, ".pgm");
  if (files.empty()) GTEST_SKIP() << no_data("images (*.pgm)");
  for (const auto& file : files) {
    const Bytes bytes = read(file);
    const auto image = read_pgm(bytes, file.string());
    ASSERT_TRUE(image.has_value()) << image.error().message;
    EXPECT_TRUE(image->not_understood.empty()) << to_string(image->not_understood.front(), file.string());
    ASSERT_EQ(image->value.pixels.size(), std::size_t{image->value.width} * image->value.height);
    // One byte a pixel, at the end of the file.
    EXPECT_TRUE(std::equal(image->value.pixels.begin(), image->value.pixels.end(),
                           bytes.end() - std::ssize(image->value.pixels)));
    const auto again = read_pgm(pgm_bytes(image->value), "written");
    ASSERT_TRUE(again.has_value());
    EXPECT_EQ(again->value, image->value);
  }
}

TEST(MapServerFiles, EachGivesAPlanOfItsImage) {
  const auto data = data_folder();
  if (!data || !std::filesystem::is_directory(*data / "ros-maps")) GTEST_SKIP() << no_data("maps of ROS");
  const auto files = files_that_end(*data / "ros-maps", ".yaml");
  ASSERT_EQ(files.size(), 7U);
  for (const auto& file : files) {
    const auto read_file = read_map_server(read_text(file), file.string());
    ASSERT_TRUE(read_file.has_value()) << read_file.error().message;
    EXPECT_TRUE(read_file->not_understood.empty());
    const auto image = read_pgm(read(file.parent_path() / read_file->value.image), read_file->value.image);
    ASSERT_TRUE(image.has_value()) << image.error().message;
    const FloorPlan plan = floor_plan_from(read_file->value, image->value);
    ASSERT_EQ(plan.cells.size(), image->value.pixels.size());
    for (const std::int8_t cell : plan.cells) ASSERT_TRUE(cell >= -1 && cell <= 100);
  }
}

TEST(MapServerFiles, TheWarehouseHasWallsAndFloor) {
  const auto data = data_folder();
  const std::string folder = "ros-maps/nav2_bringup/maps/";
  if (!data || !std::filesystem::exists(*data / folder / "warehouse.yaml")) GTEST_SKIP() << no_data("warehouse.yaml");
  const auto file = read_map_server(read_text(*data / folder / "warehouse.yaml"), "warehouse.yaml");
  ASSERT_TRUE(file.has_value());
  EXPECT_EQ(file->value.resolution_m, 0.03);
  EXPECT_EQ(file->value.origin, (Pose2{-15.1, -25.0, 0.0}));
  const auto image = read_pgm(read(*data / folder / file->value.image), file->value.image);
  ASSERT_TRUE(image.has_value());
  const FloorPlan plan = floor_plan_from(file->value, image->value);
  const auto share = [&plan](std::int8_t of) {
    return static_cast<double>(std::count(plan.cells.begin(), plan.cells.end(), of)) /
           static_cast<double>(plan.cells.size());
  };
  EXPECT_GT(share(0), 0.3);
  EXPECT_GT(share(100), 0.01);
  EXPECT_NEAR(share(0) + share(100) + share(FloorPlan::kUnknown), 1.0, 1e-9);
}

TEST(MapServerFiles, OtherYamlIsNamed) {
  const auto data = data_folder();
  const std::string name = "euroc-mh01-600/cam0_sensor.yaml";
  if (!data || !std::filesystem::exists(*data / name)) GTEST_SKIP() << no_data(name);
  const auto read_file = read_map_server(read_text(*data / name), name);
  ASSERT_FALSE(read_file.has_value());
  EXPECT_EQ(read_file.error().message, name + ":1: the key image is missing");
}

}  // namespace
}  // namespace weft::formats::test
