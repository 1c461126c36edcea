// What a camera sees of a floor that is no plane.
#include "agents/bodies/sim/bent_rays.hpp"

#include <gtest/gtest.h>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/floor/site_floor.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"
#include "agents/bodies/sim/stance.hpp"
#include "marks_seen.hpp"

namespace weft::agents::sim {
namespace {

Site flawless_site(double unevenness_m) {
  Site site = empty_site();
  site.lamps.clear();
  site.disturbances = no_disturbances();
  site.disturbances.unevenness_m = unevenness_m;
  return site;
}

Bytes seen_from(const Site& site, const CameraModel& model, const Pose3& site_from_camera,
                std::shared_ptr<const FloorSource> floor) {
  CameraOptions options;
  options.relief = relief_of(site);
  const double gloss = floor->gloss();
  Camera camera(model, options, std::move(floor), std::make_shared<const Scene>(site.boxes),
                Light(site, gloss, Random(1)));
  FloorShot shot;
  shot.site_from_camera_mid = site_from_camera;
  shot.site_from_camera.fill(site_from_camera);
  return camera.render(shot);
}

TEST(UnevenFloor, IsMetOnTheLineOfSight) {
  const Relief relief(0.01, 1);
  Pose3 site_from_camera =
      lift({3.0, 2.0, 0.3}) * given_camera_from(CameraSetup{}, no_disturbances(), "r1", 0).robot_from_camera;
  const Eigen::Vector3d eye = site_from_camera.translation;
  for (double ahead = 0.3; ahead < 2.5; ahead += 0.1) {
    const Eigen::Vector2d on_plane = eye.head<2>() + ahead * Eigen::Vector2d(0.8, 0.6);
    const FloorMet met = meet_floor(relief, site_from_camera, on_plane);
    const double height = relief.height_m(met.at.x(), met.at.y());
    const Eigen::Vector2d on_line = eye.head<2>() + (on_plane - eye.head<2>()) * (eye.z() - height) / eye.z();
    EXPECT_LT((met.at - on_line).norm(), 1e-5) << ahead;
  }
}

TEST(UnevenFloor, ShowsMarksWhereTheirHeightPutsThem) {
  const Site site = flawless_site(0.01);
  const CameraModel model = given_camera_from(site.camera, site.disturbances, "r1", 0);
  const Relief relief = *relief_of(site);
  const Pose3 site_from_camera = stance_on(relief, site.base, {3.137, 2.071, 0.7}) * model.robot_from_camera;
  const Bytes image = seen_from(site, model, site_from_camera, std::make_shared<DottedFloor>());
  const auto project = [&](const Eigen::Vector2d& p, double height_m) {
    return pixel_of(model, site_from_camera, {p.x(), p.y(), height_m});
  };
  const auto marks = marks_seen(model, site_from_camera, image,
                                [&](const Eigen::Vector2d& p) { return project(p, relief.height_m(p.x(), p.y())); });
  expect_where_they_belong(marks);
  // The parallax of up to a centimetre at 0.7 to 1.5 m: pixels.
  double most_px = 0.0;
  for (const MarkSeen& mark : marks) {
    const double height_m = relief.height_m(mark.on_floor.x(), mark.on_floor.y());
    most_px = std::max(most_px, (project(mark.on_floor, height_m) - project(mark.on_floor, 0.0)).norm());
  }
  EXPECT_GT(most_px, 2.0);
  EXPECT_LT(most_px, 8.0);
}

TEST(UnevenFloor, LiesUnderTheBodyThatSeesIt) {
  const Site site = flawless_site(0.004);
  const CameraModel model = given_camera_from(site.camera, site.disturbances, "r1", 0);
  const auto floor = make_site_floor(site, std::nullopt, {});
  ASSERT_TRUE(floor);
  const Pose3 stands = stance_on(*relief_of(site), site.base, site.robots[0].site_from_robot);
  const auto sample = body_of(config_of(site))->step({});
  ASSERT_TRUE(sample);
  const Bytes& seen = *std::get<Image>(sample->views.front().data).pixels;
  EXPECT_EQ(seen, seen_from(site, model, stands * model.robot_from_camera, *floor));
  const Pose3 on_plane = lift(site.robots[0].site_from_robot);
  EXPECT_NE(seen, seen_from(site, model, on_plane * model.robot_from_camera, *floor));
}

TEST(UnevenFloor, IsTheSameForEveryRobotAndDay) {
  Site site = flawless_site(0.004);
  site.robots[1].site_from_robot = site.robots[0].site_from_robot;
  const auto seen = [&](const std::string& robot, std::uint64_t day) {
    return *std::get<Image>(body_of(config_of(site, robot, 1, day))->step({})->views.front().data).pixels;
  };
  const Bytes first = seen("r1", 0);
  EXPECT_EQ(first, seen("r1", 3));
  EXPECT_EQ(first, seen("r2", 0));
  site.disturbances.unevenness_m = 0.0;
  EXPECT_NE(first, seen("r1", 0));
}

TEST(UnevenFloor, TiltsACameraThatLooksAhead) {
  Site site = flawless_site(0.0);
  site.robots[0].looks = {Gaze::ahead};
  const auto seen = [&] { return *std::get<Image>(body_of(config_of(site))->step({})->views.front().data).pixels; };
  const Bytes level = seen();
  site.disturbances.unevenness_m = 0.01;
  EXPECT_NE(level, seen());
}

}  // namespace
}  // namespace weft::agents::sim
