#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "storage/clouds/cloud.hpp"
#include "tests/agents/methods/topometric/sim_drive.hpp"

namespace weft::agents {
namespace {

using namespace std::chrono_literals;

/// Returns a drive through the hall that has seen something; made once.
const test::SimDrive& seen_hall() {
  static const test::SimDrive drive = [] {
    test::SimDrive made(test::topometric_site("hall"), {3.0, 1.8, 0.0});
    made.drive(1.2);
    return made;
  }();
  return drive;
}

TEST(TopometricExtract, KeepsALevelCloudOnItsFloor) {
  const test::SimDrive& drive = seen_hall();
  const TopometricContent content = drive.place();
  ASSERT_GT(content.cloud.points.size(), 2000U);
  EXPECT_GT(content.floor.points, 300U);
  std::vector<float> low;
  for (const Eigen::Vector3f& point : content.cloud.points) {
    if (std::abs(point.z()) < 0.1F) low.push_back(point.z());
    EXPECT_LE(point.z(), 2.2F);
  }
  ASSERT_GT(low.size(), 300U);
  std::nth_element(low.begin(), low.begin() + static_cast<std::ptrdiff_t>(low.size() / 2), low.end());
  EXPECT_NEAR(low[low.size() / 2], 0.0F, 0.01F);
  EXPECT_GE(content.cloud.cameras.size(), 4U);
  EXPECT_LE(content.cloud.cameras.size(), 8U);
  EXPECT_TRUE(content.scan);
}

TEST(TopometricExtract, FeaturesLieWhereTheSiteHasSomething) {
  const test::SimDrive& drive = seen_hall();
  const TopometricContent content = drive.place();
  ASSERT_GE(content.features.size(), 100U);
  ASSERT_LE(content.features.size(), most_space_features);
  int beyond = 0;
  for (const SpaceFeature& feature : content.features) {
    const Eigen::Vector2d in_site = drive.truth() * Eigen::Vector2d(feature.in_place.head<2>().cast<double>());
    const double spare_m = 0.1 + 4.0 * static_cast<double>(feature.depth_sigma_m);
    beyond += in_site.x() < -spare_m || in_site.x() > 14.0 + spare_m || in_site.y() < -spare_m ||
              in_site.y() > 10.0 + spare_m || feature.in_place.z() < -static_cast<float>(spare_m);
  }
  EXPECT_LE(beyond, static_cast<int>(content.features.size() / 20)) << "behind a wall or below the floor";
}

TEST(TopometricExtract, AContentIsSmallEnough) {
  const test::SimDrive& drive = seen_hall();
  const Bytes bytes = drive.method().encode(drive.place());
  EXPECT_LE(bytes.size(), 170'000U);
  const auto kept = clouds::compress_cloud(bytes);
  ASSERT_TRUE(kept);
  EXPECT_LE(kept->size(), 45'000U);
}

TEST(TopometricExtract, AFullPlaceKeepsWhatWasSeenFromNearest) {
  TopometricConfig config;
  config.place.most_points = 2000;
  test::SimDrive drive(test::topometric_site("hall"), {3.0, 1.8, 0.0}, 1001, 0, config);
  drive.drive(1.2);
  const TopometricContent content = drive.place();
  EXPECT_LE(content.cloud.points.size(), 2000U);
  EXPECT_GT(content.cloud.points.size(), 1800U);
  float farthest = 0.0F;
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i)
    farthest = std::max(farthest, (content.cloud.points[i] - content.cloud.cameras[content.cloud.frames[i]]).norm());
  EXPECT_LT(farthest, 3.5F);
}

TEST(TopometricExtract, RefusalsAreNamed) {
  const test::SimDrive& drive = seen_hall();
  const auto reason = [&](const Topometric::Odometry& odometry, const View& view) {
    const auto content = drive.method().extract(odometry, view);
    return content ? "" : content.error().reason;
  };
  View view = drive.view();
  view.data = Payload{};
  EXPECT_EQ(reason(drive.odometry(), view), "not_a_pair");
  view = drive.view();
  std::get<StereoPair>(view.data).right = {};
  EXPECT_EQ(reason(drive.odometry(), view), "wrong_size");
  EXPECT_EQ(reason(Topometric::Odometry{}, drive.view()), "blind");
  Topometric::Odometry forgetful = drive.odometry();
  forgetful.window->go_blind(1.0);
  view = drive.view();
  const auto& left = std::get<StereoPair>(view.data).left;
  const Image plain{left.width, left.height, std::make_shared<const Bytes>(left.pixels->size(), std::uint8_t{99})};
  view.data = StereoPair{plain, plain};
  EXPECT_EQ(reason(forgetful, view), "too_blank");
}

}  // namespace
}  // namespace weft::agents
