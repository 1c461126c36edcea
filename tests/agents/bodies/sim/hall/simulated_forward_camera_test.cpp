// What a robot sees that looks ahead.
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "agents/bodies/sim/hall/exposure_control.hpp"
#include "agents/bodies/sim/hall/hall_camera.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

Site forward_site() {
  Site site = empty_site();
  site.robots.front().looks = {Gaze::ahead};
  site.boxes.push_back({Box::Kind::rack, "a rack", {12.0, 9.0, 0.0}, 10.8, 1.0, 4.5});
  return site;
}

const Image& image_of(const Sample& sample) {
  return std::get<Image>(sample.views.front().data);
}

double mean_of(const Image& image) {
  return std::accumulate(image.pixels->begin(), image.pixels->end(), 0.0) / static_cast<double>(image.pixels->size());
}

Sample stepped(Body& body, int steps, const Twist& command = {}) {
  std::optional<Sample> last;
  for (int i = 0; i < steps; ++i) {
    Result<Sample> sample = body.step(command);
    EXPECT_TRUE(sample);
    if (!sample->views.empty()) last = std::move(*sample);
  }
  return *last;
}

TEST(SimulatedForwardCamera, IsTheCameraOfRobotsThatLookAhead) {
  const auto body = body_of(config_of(forward_site()));
  const Sample sample = stepped(*body, 3);
  EXPECT_EQ(sample.views.front().sensor, "forward");
  EXPECT_EQ(image_of(sample).width, 320);
  EXPECT_EQ(image_of(sample).height, 240);
  ASSERT_EQ(body->rig().sensors.size(), 1U);
  EXPECT_EQ(body->rig().camera().id, sample.views.front().calibration);
  const auto down = body_of(config_of(forward_site(), "r2"));
  EXPECT_EQ(stepped(*down, 3).views.front().sensor, "floor");
}

TEST(SimulatedForwardCamera, SameSeedSameImagesAndAnotherDayOthers) {
  const auto a = body_of(config_of(forward_site()));
  const auto b = body_of(config_of(forward_site()));
  const auto other = body_of(config_of(forward_site(), "r1", 1, 2));
  const Sample first = stepped(*a, 5, {0.3, 0.1});
  EXPECT_EQ(*image_of(first).pixels, *image_of(stepped(*b, 5, {0.3, 0.1})).pixels);
  EXPECT_NE(*image_of(first).pixels, *image_of(stepped(*other, 5, {0.3, 0.1})).pixels);
}

TEST(SimulatedForwardCamera, ExposesItselfToItsMeanInAnyLight) {
  for (const double light : {0.1, 1.0, 4.0}) {
    Site site = forward_site();
    site.disturbances.exposure_drift = 0.0;
    site.change.light = light;
    const auto body = body_of(config_of(site));
    EXPECT_NEAR(mean_of(image_of(stepped(*body, 30, {0.05, 0.0}))), site.forward_camera.mean_grey, 12.0) << light;
  }
}

TEST(SimulatedForwardCamera, ExposesAsItIsToldAndSaysHow) {
  Site site = forward_site();
  site.disturbances.exposure_drift = 0.0;
  site.disturbances.exposure_s = 0.005;
  const auto body = body_of(config_of(site));
  const Sample own = stepped(*body, 30, {0.05, 0.0});
  ASSERT_TRUE(own.views.front().exposure);
  const Exposure third{own.views.front().exposure->light_s() / 3.0, 1.0};
  ASSERT_TRUE(body->expose("forward", third));
  const Sample told = stepped(*body, 2, {0.05, 0.0});
  ASSERT_TRUE(told.views.front().exposure);
  EXPECT_NEAR(told.views.front().exposure->time_s, third.time_s, 1e-9);
  EXPECT_EQ(told.views.front().exposure->gain, 1.0);
  EXPECT_NEAR(mean_of(image_of(told)) / mean_of(image_of(own)), 1.0 / 3.0, 0.05);
}

TEST(SimulatedForwardCamera, ExposesItselfAgainWhenItIsNotToldForTwoSeconds) {
  Site site = forward_site();
  site.disturbances.exposure_drift = 0.0;
  const auto body = body_of(config_of(site));
  const Exposure dark{5e-4, 1.0};
  for (int i = 0; i < 90; ++i) {
    ASSERT_TRUE(body->expose("forward", dark));
    stepped(*body, 1, {0.05, 0.0});
  }
  EXPECT_LT(mean_of(image_of(stepped(*body, 50, {0.05, 0.0}))), 40.0) << "told less than two seconds ago";
  EXPECT_NEAR(mean_of(image_of(stepped(*body, 40, {0.05, 0.0}))), site.forward_camera.mean_grey, 12.0);
}

TEST(SimulatedForwardCamera, WhoCannotBeToldSaysSo) {
  Site site = forward_site();
  site.robots.front().looks = {Gaze::down, Gaze::ahead};
  const auto body = body_of(config_of(site));
  EXPECT_TRUE(body->expose("forward", {0.005, 1.0}));
  EXPECT_EQ(body->expose("floor", {0.005, 1.0}).error().code, ErrorCode::refused);
  EXPECT_EQ(body->expose("rear", {0.005, 1.0}).error().code, ErrorCode::not_found);
  site.forward_camera.exposes_itself = false;
  const auto built_in = body_of(config_of(site));
  EXPECT_EQ(built_in->expose("forward", {0.005, 1.0}).error().code, ErrorCode::refused);
}

TEST(SimulatedForwardCamera, AHeadlightShowsWhatTheDarkHides) {
  Site site = forward_site();
  site.change.light = 0.05;
  site.forward_camera.exposes_itself = false;
  const auto dark = body_of(config_of(site));
  site.forward_camera.headlight = 4.0;
  const auto lit = body_of(config_of(site));
  EXPECT_GT(mean_of(image_of(stepped(*lit, 3))), 2.0 * mean_of(image_of(stepped(*dark, 3))));
}

TEST(SimulatedForwardCamera, SeesWhoWalksBefore) {
  Site site = forward_site();
  site.disturbances = no_disturbances();
  const auto alone = body_of(config_of(site));
  site.movers.push_back({Mover::Kind::person, {{7.0, 4.0}, {7.0, 8.0}}, 1.0, 2.0});
  const auto followed = body_of(config_of(site));
  const Sample empty = stepped(*alone, 2);
  const Sample walked = stepped(*followed, 2);
  int changed = 0;
  for (std::size_t i = 0; i < image_of(empty).pixels->size(); ++i)
    changed += std::abs((*image_of(empty).pixels)[i] - (*image_of(walked).pixels)[i]) > 8 ? 1 : 0;
  EXPECT_GT(changed, 2000);
  EXPECT_LT(changed, 20000);
}

/// Shows that the middle of a lamp, which is the brightest there is, is where the camera model puts it.
TEST(HallCamera, DrawsThingsWhereTheCameraModelPutsThem) {
  Site site = empty_site();
  site.lamps = {{14.0, 5.0, 5.0, 1.0}};
  site.disturbances = no_disturbances();
  const auto body_floor = make_sim_body(config_of(site));
  ASSERT_TRUE(body_floor);
  CameraModel camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 200.0;
  camera.cx = 159.5;
  camera.cy = 119.5;
  camera.robot_from_camera = downward_mount(0.2, 0.0, 0.4, -0.4, 0.0, 0.0);
  class Grey final : public FloorSource {
    void fill(TileKey, std::span<std::uint8_t> texels) const override {
      std::fill(texels.begin(), texels.end(), 128);
    }
    double gloss() const override { return 0.0; }
  };
  HallCamera eye(camera, {}, std::make_shared<const Hall>(site, Grey(), Photographed{}), {},
                 HallLight(site, Random(1)));
  HallShot shot;
  const Pose3 site_from_camera = lift(Pose2{4.0, 6.0, 0.0}) * camera.robot_from_camera;
  shot.site_from_camera.fill(site_from_camera);
  shot.noise_grey = 0.0;
  shot.gain = 0.15;
  const HallImage image = eye.take(shot);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0.0;
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      if (image.grey[static_cast<std::size_t>(v * 320 + u)] < 100) continue;
      sum += Eigen::Vector2d(u, v);
      weight += 1.0;
    }
  }
  ASSERT_GT(weight, 10.0);
  const Eigen::Vector3d p = site_from_camera.inverse() * Eigen::Vector3d(14.0, 5.0, 5.0);
  EXPECT_NEAR(sum.x() / weight, camera.cx + camera.fx * p.x() / p.z(), 1.0);
  EXPECT_NEAR(sum.y() / weight, camera.cy + camera.fy * p.y() / p.z(), 1.0);
}

TEST(ExposureControl, ExposesLongerFirstAndAmplifiesThen) {
  ForwardCameraSetup setup;
  setup.longest_exposure_s = 0.02;
  ExposureControl control(setup, 0.005);
  for (int i = 0; i < 50; ++i) control.taken(55.0);
  EXPECT_NEAR(control.gain(), 2.0, 0.01);
  EXPECT_NEAR(control.exposure_s(), 0.01, 1e-4);
  EXPECT_EQ(control.amplified(), 1.0);
  for (int i = 0; i < 50; ++i) control.taken(11.0);
  EXPECT_NEAR(control.exposure_s(), 0.02, 1e-9);
  EXPECT_NEAR(control.amplified(), 2.5, 0.05);
  for (int i = 0; i < 50; ++i) control.taken(0.0);
  EXPECT_EQ(control.gain(), setup.most_gain) << "of a black image it does not ask for all there is";
}

TEST(ExposureControl, WhatItIsToldIsKeptWithinWhatItCan) {
  ForwardCameraSetup setup;
  setup.longest_exposure_s = 0.02;
  setup.most_gain = 40.0;
  ExposureControl control(setup, 0.005);
  ASSERT_TRUE(control.tell({0.01, 3.0}));
  EXPECT_NEAR(control.exposure_s(), 0.01, 1e-12);
  EXPECT_NEAR(control.amplified(), 3.0, 1e-12);
  EXPECT_NEAR(control.gain(), 6.0, 1e-9);
  ASSERT_TRUE(control.tell({0.1, 1.0}));
  EXPECT_NEAR(control.exposure_s(), 0.02, 1e-12) << "the light of it is amplified for";
  EXPECT_NEAR(control.amplified(), 5.0, 1e-9);
  ASSERT_TRUE(control.tell({10.0, 10.0}));
  EXPECT_NEAR(control.gain(), 40.0, 1e-9);
  ASSERT_TRUE(control.tell({0.0, 1.0}));
  EXPECT_GT(control.gain(), 0.0);
  EXPECT_LT(control.gain(), 0.1);
}

TEST(ExposureControl, WhileToldItsOwnRests) {
  ExposureControl control({}, 0.005);
  control.comes(0.0);
  ASSERT_TRUE(control.tell({0.005, 1.0}));
  for (int i = 0; i < 20; ++i) control.taken(10.0);
  EXPECT_EQ(control.gain(), 1.0);
  control.comes(1.9);
  EXPECT_EQ(control.gain(), 1.0);
  control.comes(2.1);
  EXPECT_EQ(control.gain(), 1.0) << "it goes on from there";
  for (int i = 0; i < 50; ++i) control.taken(10.0);
  EXPECT_NEAR(control.gain(), 11.0, 0.1);
}

TEST(ExposureControl, WithoutBlurItIsToldAndSaysTheSame) {
  ExposureControl control({}, 0.0);
  EXPECT_EQ(control.exposure_s(), 0.0);
  const Exposure own = control.now();
  EXPECT_EQ(own.gain, 1.0);
  ASSERT_TRUE(control.tell({2.0 * own.time_s, 1.0}));
  EXPECT_NEAR(control.gain(), 2.0, 1e-12);
  EXPECT_EQ(control.exposure_s(), 0.0);
  EXPECT_NEAR(control.now().time_s, 2.0 * own.time_s, 1e-12);
}

}  // namespace
}  // namespace weft::agents::sim
