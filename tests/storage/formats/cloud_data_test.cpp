#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "storage/formats/cloud.hpp"
#include "tests/storage/formats/data_files.hpp"

namespace weft::formats::test {
namespace {

bool same_bits(const std::vector<Eigen::Vector3f>& first, const std::vector<Eigen::Vector3f>& second) {
  return first.size() == second.size() &&
         std::memcmp(first.data(), second.data(), first.size() * sizeof(Eigen::Vector3f)) == 0;
}

std::size_t stated(const Bytes& bytes, const std::string& before) {
  const std::string head(bytes.begin(), bytes.begin() + std::min<std::ptrdiff_t>(600, std::ssize(bytes)));
  return std::stoul(head.substr(head.find(before) + before.size()));
}

class CloudFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto data = data_folder();
    if (!data || !std::filesystem::is_directory(*data / "point-clouds")) GTEST_SKIP() << no_data("point clouds");
    folder_ = *data;
  }
  std::filesystem::path folder_;
};

TEST_F(CloudFiles, EveryPcdHoldsTheStatedPoints) {
  const auto files = files_that_end(folder_, ".pcd");
  ASSERT_EQ(files.size(), 4U);
  for (const auto& file : files) {
    const Bytes bytes = read(file);
    const auto cloud = read_pcd(bytes, file.string());
    ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
    EXPECT_TRUE(cloud->not_understood.empty());
    EXPECT_EQ(cloud->value.points.size(), stated(bytes, "POINTS ")) << file;
    EXPECT_EQ(cloud->value.width, stated(bytes, "WIDTH "));
    for (const Eigen::Vector3f& point : cloud->value.points) {
      ASSERT_TRUE(point.allFinite() ? point.norm() < 100.0F : std::isnan(point.x())) << file;
    }
    const auto again = read_pcd(pcd_bytes(cloud->value, CloudCoding::binary), "written");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_TRUE(same_bits(cloud->value.points, again->value.points)) << file;
    EXPECT_EQ(again->value.width, cloud->value.width);
    EXPECT_EQ(again->value.world_from_sensor.rotation.coeffs(), cloud->value.world_from_sensor.rotation.coeffs());
  }
}

TEST_F(CloudFiles, KinectsCloudKeepsItsOrderAndItsHoles) {
  const auto file = folder_ / "point-clouds/pcl/capture0001.pcd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << no_data(file.string());
  const auto cloud = read_pcd(read(file), "capture0001.pcd");
  ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
  EXPECT_EQ(cloud->value.width, 640U);
  EXPECT_EQ(cloud->value.height, 480U);
  const auto holes = std::count_if(cloud->value.points.begin(), cloud->value.points.end(),
                                   [](const Eigen::Vector3f& point) { return std::isnan(point.x()); });
  EXPECT_GT(holes, 1000);
  EXPECT_LT(holes, 640 * 480 / 2);
}

TEST_F(CloudFiles, EveryPlyHoldsTheStatedPointsAndIntensities) {
  const auto files = files_that_end(folder_, ".ply");
  ASSERT_EQ(files.size(), 2U);
  for (const auto& file : files) {
    const Bytes bytes = read(file);
    const auto cloud = read_ply(bytes, file.string());
    ASSERT_TRUE(cloud.has_value()) << cloud.error().message;
    EXPECT_TRUE(cloud->not_understood.empty());
    EXPECT_EQ(cloud->value.points.size(), stated(bytes, "element vertex ")) << file;
    EXPECT_EQ(cloud->value.intensities.size(), cloud->value.points.size());
    for (const Eigen::Vector3f& point : cloud->value.points) ASSERT_LT(point.norm(), 200.0F);
    const auto again = read_ply(ply_bytes(cloud->value, CloudCoding::text), "written");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_TRUE(same_bits(cloud->value.points, again->value.points));
    EXPECT_EQ(cloud->value.intensities, again->value.intensities);
  }
}

}  // namespace
}  // namespace weft::formats::test
