// Checks what a robot sees that looks up, against rays.
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/hall/hall_camera.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"
#include "agents/perception/lens.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kDegree = M_PI / 180.0;
const Pose2 kHere{10.0, 6.0, 0.4};

/// Returns a hall of 6 m height with one lamp, half a metre below the ceiling, and a camera under it.
Site site_under_a_lamp() {
  Site site = empty_site();
  site.robots.front().looks = {Gaze::up};
  site.disturbances = no_disturbances();
  site.lamps = {{10.3, 6.2, 5.5, 0.05}};
  site.hall.ceiling_m = 6.0;
  site.hall.ceiling.beams_every_m = 0.0;
  site.hall.ceiling.lamp_length_m = 0.3;
  site.ceiling_camera.exposes_itself = false;
  site.ceiling_camera.bloom = 0.0;
  return site;
}

Moment moment_under(const Pose2& site_from_robot, const Twist& moving = {}) {
  Moment moment;
  moment.site_from_robot = site_from_robot;
  moment.site_from_camera = [site_from_robot, moving](const Pose3& robot_from_camera, double from_now_s) {
    return lift(site_from_robot *
                se2_exp(Eigen::Vector3d(moving.linear_m_s * from_now_s, 0.0, moving.angular_rad_s * from_now_s))) *
           robot_from_camera;
  };
  return moment;
}

Image look_up(const Site& site, const Moment& moment) {
  const CameraOwner owner{"r1", 0, Random(1), Random(2)};
  const auto floor = std::make_shared<DottedFloor>();
  return std::get<Image>(make_ceiling_camera(site, owner, floor, Photographed{}, Random(1))->look(moment));
}

int grey_at(const Image& image, const Eigen::Vector2d& pixel) {
  const auto column = static_cast<std::size_t>(std::lround(pixel.x()));
  const auto row = static_cast<std::size_t>(std::lround(pixel.y()));
  return (*image.pixels)[row * static_cast<std::size_t>(image.width) + column];
}

/// Returns the middle of what is white.
Eigen::Vector2d middle_of_white(const Image& image) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
  for (int v = 0; v < image.height; ++v) {
    for (int u = 0; u < image.width; ++u) {
      if (grey_at(image, {u, v}) < 250) continue;
      sum += Eigen::Vector2d(u, v);
      count += 1.0;
    }
  }
  EXPECT_GT(count, 20.0);
  return sum / count;
}

/// Returns where the camera as it is sees a point of the site.
Eigen::Vector2d seen_at(const Site& site, const Eigen::Vector3d& in_site) {
  CameraModel camera = given_ceiling_camera_from(site.ceiling_camera, site.disturbances, "r1");
  camera.robot_from_camera = upward_mount(site.ceiling_camera, true);
  const Eigen::Vector3d p = (lift(kHere) * camera.robot_from_camera).inverse() * in_site;
  return pixel_from_normalised(camera, p.head<2>() / p.z());
}

const Image& upward_image(const Sample& sample) {
  return std::get<Image>(sample.views.front().data);
}

Sample stepped_up(Body& body, int steps, const Twist& command = {}) {
  std::optional<Sample> last;
  for (int i = 0; i < steps; ++i) {
    Result<Sample> sample = body.step(command);
    EXPECT_TRUE(sample);
    if (!sample->views.empty()) last = std::move(*sample);
  }
  return *last;
}

TEST(SimulatedCeilingCamera, IsTheCameraOfRobotsThatLookUp) {
  Site site = site_under_a_lamp();
  const auto body = body_of(config_of(site));
  const Sample sample = stepped_up(*body, 3);
  EXPECT_EQ(sample.views.front().sensor, "ceiling");
  EXPECT_EQ(sample.views.front().calibration, "r1/ceiling");
  EXPECT_EQ(upward_image(sample).width, 640);
  EXPECT_EQ(upward_image(sample).height, 480);
  EXPECT_EQ(body->rig().sensors.front().gaze(), Gaze::up);
  site.robots.front().looks = {Gaze::down, Gaze::ahead, Gaze::up};
  const Rig all = body_of(config_of(site))->rig();
  ASSERT_EQ(all.sensors.size(), 3U);
  EXPECT_EQ(all.sensors[0].gaze(), Gaze::down);
  EXPECT_EQ(all.sensors[1].gaze(), Gaze::ahead);
  EXPECT_EQ(all.sensors[2].gaze(), Gaze::up);
}

TEST(SimulatedCeilingCamera, IsNoCameraForWhoNeedsAnother) {
  const Rig rig = body_of(config_of(site_under_a_lamp()))->rig();
  EXPECT_TRUE(choose(rig, {SensorKind::camera, Gaze::up, 1}, "a method", {}));
  const Result<Rig> down = choose(rig, {SensorKind::camera, Gaze::down, 1}, "a method", {});
  ASSERT_FALSE(down);
  EXPECT_EQ(down.error().message,
            "method a method needs a camera that looks down; the body has: ceiling (camera, up)");
}

TEST(SimulatedCeilingCamera, ARobotMayHaveItsOwn) {
  Site site = site_under_a_lamp();
  site.robots.front().ceiling_camera = site.ceiling_camera;
  site.robots.front().ceiling_camera->height_m = 0.8;
  site.robots.back().looks = {Gaze::up};
  EXPECT_EQ(body_of(config_of(site))->rig().camera().robot_from_camera.translation.z(), 0.8);
  EXPECT_EQ(body_of(config_of(site, "r2"))->rig().camera().robot_from_camera.translation.z(), 0.35);
}

TEST(SimulatedCeilingCamera, SameSeedSameImagesAndAnotherDayOthers) {
  Site site = site_under_a_lamp();
  site.disturbances = {};
  site.hall.ceiling.kind = CeilingKind::concrete;
  const auto seen_on = [&](std::uint64_t day) {
    return *upward_image(stepped_up(*body_of(config_of(site, "r1", 1, day)), 5, {0.3, 0.1})).pixels;
  };
  EXPECT_EQ(seen_on(0), seen_on(0));
  EXPECT_NE(seen_on(0), seen_on(2));
}

TEST(SimulatedCeilingCamera, ALampIsWhiteAndBlooms) {
  Site site = site_under_a_lamp();
  const Image sharp = look_up(site, moment_under(kHere));
  site.ceiling_camera.bloom = 0.1;
  const Image blooming = look_up(site, moment_under(kHere));
  const Eigen::Vector2d lamp = seen_at(site, {10.3, 6.2, 5.5});
  EXPECT_EQ(grey_at(sharp, lamp), 255);
  EXPECT_EQ(grey_at(blooming, lamp), 255);
  const auto glow = [&](double away) {
    const Eigen::Vector2d at = lamp + Eigen::Vector2d(away, 0.0);
    return grey_at(blooming, at) - grey_at(sharp, at);
  };
  EXPECT_GT(glow(14.0), 8) << "just beside it";
  EXPECT_GT(glow(14.0), 2 * glow(30.0));
  EXPECT_GE(glow(30.0), 1);
  EXPECT_LE(glow(150.0), 1);
}

TEST(SimulatedCeilingCamera, ATiltOfTheMountShiftsTheImage) {
  Site site = site_under_a_lamp();
  const Eigen::Vector2d upright = middle_of_white(look_up(site, moment_under(kHere)));
  EXPECT_LT((upright - seen_at(site, {10.3, 6.2, 5.5})).norm(), 0.5);
  site.ceiling_camera.tilt_error_forward_rad = 2.0 * kDegree;
  const Eigen::Vector2d forward = middle_of_white(look_up(site, moment_under(kHere)));
  EXPECT_LT((forward - seen_at(site, {10.3, 6.2, 5.5})).norm(), 0.5);
  EXPECT_NEAR((forward - upright).y(), -300.0 * std::tan(2.0 * kDegree), 0.5) << "the image's bottom is ahead";
  EXPECT_NEAR((forward - upright).x(), 0.0, 0.5);
  site.ceiling_camera.tilt_error_forward_rad = 0.0;
  site.ceiling_camera.tilt_left_rad = 2.0 * kDegree;
  const Eigen::Vector2d left = middle_of_white(look_up(site, moment_under(kHere)));
  EXPECT_NEAR((left - upright).x(), 300.0 * std::tan(2.0 * kDegree), 0.5) << "its right is the robot's right";
}

/// Expects each corner of a lamp's face where the camera model puts it: white inside of it, and not outside.
void expect_corners(const Site& site) {
  const Image image = look_up(site, moment_under(kHere));
  const Lamp& lamp = site.lamps.front();
  const double x = 0.5 * site.hall.ceiling.lamp_length_m;
  const double y = 0.5 * site.hall.ceiling.lamp_width_m;
  const Eigen::Vector2d middle = seen_at(site, {lamp.x, lamp.y, lamp.height_m});
  for (const auto& [side_x, side_y] : {std::pair{1.0, 1.0}, {1.0, -1.0}, {-1.0, 1.0}, {-1.0, -1.0}}) {
    const Eigen::Vector2d corner = seen_at(site, {lamp.x + side_x * x, lamp.y + side_y * y, lamp.height_m});
    const Eigen::Vector2d inwards = (middle - corner).normalized();
    EXPECT_GE(grey_at(image, corner + 3.0 * inwards), 250) << corner.transpose();
    EXPECT_LE(grey_at(image, corner - 3.0 * inwards), 200) << corner.transpose();
  }
}

TEST(SimulatedCeilingCamera, ALensThatBendsShowsALampWhereItsModelSays) {
  Site site = site_under_a_lamp();
  site.hall.ceiling.lamp_length_m = site.hall.ceiling.lamp_width_m = 1.2;
  site.ceiling_camera.k1 = -0.06;
  site.ceiling_camera.k2 = 0.01;
  site.ceiling_camera.p1 = 0.002;
  for (const double away : {0.0, 2.0, 3.5}) {
    site.lamps.front().x = kHere.x + away;
    site.lamps.front().y = kHere.y - 0.4 * away;
    expect_corners(site);
  }
}

TEST(SimulatedCeilingCamera, AFisheyeShowsALampWhereItsModelSays) {
  Site site = site_under_a_lamp();
  site.hall.ceiling.lamp_length_m = site.hall.ceiling.lamp_width_m = 1.6;
  site.ceiling_camera.lens = LensModel::equidistant;
  site.ceiling_camera.focal_px = 240.0;
  site.ceiling_camera.k1 = -0.02;
  site.ceiling_camera.tilt_forward_rad = 10.0 * kDegree;
  for (const double away : {0.0, 3.0, 6.0, 8.0}) {
    site.lamps.front().x = kHere.x + 0.6 * away;
    site.lamps.front().y = kHere.y + 0.5 * away;
    expect_corners(site);
  }
}

TEST(SimulatedCeilingCamera, BeyondTheCircleOfAFisheyeNothingIsSeen) {
  Site site = site_under_a_lamp();
  site.ceiling_camera.lens = LensModel::equidistant;
  site.ceiling_camera.widest_rad = 0.9;
  const Image image = look_up(site, moment_under(kHere));
  const Eigen::Vector2d middle(site.ceiling_camera.cx_px, site.ceiling_camera.cy_px);
  EXPECT_EQ(grey_at(image, middle + Eigen::Vector2d(0.95 * 300.0, 0.0)), 0);
  EXPECT_GT(grey_at(image, middle + Eigen::Vector2d(0.85 * 300.0, 0.0)), 5);
}

TEST(SimulatedCeilingCamera, ADuctHidesWhatLiesAboveIt) {
  Site site = site_under_a_lamp();
  const Eigen::Vector2d lamp = seen_at(site, {10.3, 6.2, 5.5});
  ASSERT_EQ(grey_at(look_up(site, moment_under(kHere)), lamp), 255);
  site.ducts.push_back({2.0, 6.2, 18.0, 6.2, 1.0, 0.8, 0.4});
  EXPECT_LT(grey_at(look_up(site, moment_under(kHere)), lamp), 200);
}

TEST(SimulatedCeilingCamera, AMastStandsStillInTheImage) {
  Site site = site_under_a_lamp();
  site.hall.ceiling.kind = CeilingKind::concrete;
  site.disturbances.exposure_s = 0.01;
  const Twist turning{0.5, 1.0};
  const Image bare = look_up(site, moment_under(kHere, turning));
  site.ceiling_camera.mast = Mast{.forward_m = 0.3, .left_m = 0.0, .side_m = 0.1, .height_m = 1.2};
  const Image here = look_up(site, moment_under(kHere, turning));
  const Image there = look_up(site, moment_under({6.0, 3.0, 2.0}, turning));
  // Its nearer lower edges are 0.25 m ahead, and it ends 0.85 m above the camera.
  const Eigen::Vector2d on_it(site.ceiling_camera.cx_px, site.ceiling_camera.cy_px + 300.0 * 0.3 / 0.7);
  EXPECT_NEAR(grey_at(here, on_it), grey_at(there, on_it), 20) << "but for the light";
  EXPECT_NE(grey_at(here, on_it), grey_at(bare, on_it));
  int changed = 0;
  for (std::size_t i = 0; i < bare.pixels->size(); ++i) changed += (*bare.pixels)[i] != (*here.pixels)[i] ? 1 : 0;
  EXPECT_GT(changed, 3000);
  EXPECT_LT(changed, 30'000) << "and nothing else";
}

TEST(SimulatedCeilingCamera, ARollingShutterShearsWhatIsSeen) {
  Site site = site_under_a_lamp();
  const Image at_once = look_up(site, moment_under(kHere));
  site.disturbances.rolling_shutter_s = 0.02;
  EXPECT_EQ(*at_once.pixels, *look_up(site, moment_under(kHere)).pixels);
  EXPECT_NE(*at_once.pixels, *look_up(site, moment_under(kHere, {0.5, 0.8})).pixels);
}

TEST(SimulatedCeilingCamera, ExposesItselfForWhatIsNoLamp) {
  Site site = site_under_a_lamp();
  site.ceiling_camera.exposes_itself = true;
  site.hall.ceiling.lamp_length_m = site.hall.ceiling.lamp_width_m = 1.0;
  const auto body = body_of(config_of(site));
  const Image image = upward_image(stepped_up(*body, 30, {0.02, 0.0}));
  const double mean =
      std::accumulate(image.pixels->begin(), image.pixels->end(), 0.0) / static_cast<double>(image.pixels->size());
  EXPECT_NEAR(mean, site.ceiling_camera.mean_grey, 8.0);
}

TEST(SimulatedCeilingCamera, HalfOfTheLampsMayBeOff) {
  Site site = site_under_a_lamp();
  site.lamps.clear();
  for (const double x : {8.0, 9.5, 10.5, 12.0}) site.lamps.push_back({x, 6.5, 5.5, 0.05});
  const auto white = [&] {
    const Image image = look_up(site, moment_under(kHere));
    return std::count(image.pixels->begin(), image.pixels->end(), std::uint8_t{255});
  };
  const auto all = static_cast<double>(white());
  site.change.lamps_failed = 0.5;
  EXPECT_NEAR(static_cast<double>(white()) / all, 0.5, 0.1);
}

TEST(HallCamera, SaysHowFarWhatAPixelSeesIs) {
  const Site site = site_under_a_lamp();
  for (const LensModel lens : {LensModel::radtan, LensModel::equidistant}) {
    CeilingCameraSetup setup = site.ceiling_camera;
    setup.lens = lens;
    const CameraModel camera = given_ceiling_camera_from(setup, site.disturbances, "r1");
    HallCamera looks_up(camera, {}, std::make_shared<const Hall>(site, DottedFloor(), Photographed{}), {},
                        HallLight(site, Random(1)));
    const Pose3 site_from_camera = lift(kHere) * camera.robot_from_camera;
    const Eigen::Vector2d ray = normalised_from_pixel(camera, {220.0, 160.0});
    EXPECT_NEAR(looks_up.distance_m(site_from_camera, 220, 160), 5.65 * std::hypot(1.0, ray.norm()), 1e-3);
  }
}

}  // namespace
}  // namespace weft::agents::sim
