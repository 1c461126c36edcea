// What a rolling shutter does to images, of the floor camera and of the one that looks ahead.
#include "agents/bodies/sim/readout.hpp"

#include <gtest/gtest.h>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"
#include "marks_seen.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kReadoutS = 0.03;
const Twist kRollingOn{0.8, 1.2};

Site rolling_site(double readout_s) {
  Site site = empty_site();
  site.lamps.clear();
  site.disturbances = no_disturbances();
  site.disturbances.rolling_shutter_s = readout_s;
  return site;
}

/// Makes the moment of a robot in motion.
Moment moment_at(const Pose2& site_from_robot, const Twist& moving) {
  Moment moment;
  moment.site_from_robot = site_from_robot;
  moment.site_from_camera = [site_from_robot, moving](const Pose3& robot_from_camera, double from_now_s) {
    return lift(site_from_robot *
                se2_exp(Eigen::Vector3d(moving.linear_m_s * from_now_s, 0.0, moving.angular_rad_s * from_now_s))) *
           robot_from_camera;
  };
  return moment;
}

CameraOwner somebody() {
  return {"r1", 0, Random(1), Random(2)};
}

Bytes floor_seen(const Site& site, const Moment& moment) {
  const auto eye = make_floor_camera(site, somebody(), std::make_shared<DottedFloor>(), Random(1));
  return *std::get<Image>(eye->look(moment)).pixels;
}

/// Returns where the camera is when the row is taken.
Pose3 camera_at_row(const Moment& moment, const CameraModel& model, double row) {
  return moment.site_from_camera(model.robot_from_camera, row_time_s(row, model.height, kReadoutS));
}

/// Returns where a point is seen when each row is taken at its own time: in the row whose time it is seen at.
Eigen::Vector2d pixel_in_its_row(const Moment& moment, const CameraModel& model, const Eigen::Vector3d& in_site) {
  double row = model.height / 2.0;
  Eigen::Vector2d seen;
  for (int i = 0; i < 20; ++i) {
    seen = pixel_of(model, camera_at_row(moment, model, row), in_site);
    row = seen.y();
  }
  return seen;
}

TEST(Readout, TheMiddleRowIsTheImagesTime) {
  EXPECT_DOUBLE_EQ(row_time_s(0, 480, 0.02), -0.01);
  EXPECT_DOUBLE_EQ(row_time_s(239.5, 480, 0.02), 0.0);
  EXPECT_DOUBLE_EQ(row_time_s(479, 480, 0.02), 0.01);
  EXPECT_EQ(row_time_s(0, 1, 0.02), 0.0);
}

TEST(RollingShutter, ShowsMarksWhereTheyAreInTheTimeOfTheirRow) {
  const Site site = rolling_site(kReadoutS);
  const CameraModel model = given_camera_from(site.camera, site.disturbances, "r1", 0);
  const Moment moment = moment_at({3.137, 2.071, 0.7}, kRollingOn);
  const Bytes image = floor_seen(site, moment);
  const Pose3 middle = moment.site_from_camera(model.robot_from_camera, 0.0);
  const auto marks = marks_seen(model, middle, image, [&](const Eigen::Vector2d& p) {
    return pixel_in_its_row(moment, model, {p.x(), p.y(), 0.0});
  });
  expect_where_they_belong(marks);
  double most_px = 0.0;
  for (const MarkSeen& mark : marks) {
    const Eigen::Vector3d at(mark.on_floor.x(), mark.on_floor.y(), 0.0);
    most_px = std::max(most_px, (pixel_in_its_row(moment, model, at) - pixel_of(model, middle, at)).norm());
  }
  EXPECT_GT(most_px, 4.0) << "far from where one moment would show them";
}

TEST(RollingShutter, ShowsAPillarInTheTimeOfItsRows) {
  Site site = rolling_site(kReadoutS);
  const CameraModel model = given_camera_from(site.camera, site.disturbances, "r1", 0);
  const Moment moment = moment_at({2.0, 2.0, 0.0}, {0.0, 1.5});
  const Bytes bare = floor_seen(site, moment);
  site.boxes.push_back({Box::Kind::pillar, "pillar", {3.5, 2.0, 0.0}, 0.4, 0.4, 3.0});
  const Bytes seen = floor_seen(site, moment);
  // The face at x = 3.3 stands on the floor between y = 1.8 and 2.2 and rises out of the picture.
  int inside = 0;
  int changed_inside = 0;
  int changed_outside = 0;
  for (int v = 0; v < model.height; v += 3) {
    const Pose3 site_from_camera = camera_at_row(moment, model, v);
    const Eigen::Vector3d& eye = site_from_camera.translation;
    for (int u = 0; u < model.width; u += 3) {
      const Eigen::Vector2d ray = normalised_from_pixel(model, {u, v});
      const Eigen::Vector3d direction = site_from_camera.rotation * Eigen::Vector3d(ray.x(), ray.y(), 1.0);
      const Eigen::Vector3d hit = eye + (3.3 - eye.x()) / direction.x() * direction;
      const bool hits = direction.x() > 0.0 && std::abs(hit.y() - 2.0) < 0.2 && hit.z() > 0.0 && hit.z() < 3.0;
      if (std::min({std::abs(std::abs(hit.y() - 2.0) - 0.2), std::abs(hit.z())}) < 0.006) continue;  // its edge
      const auto at = static_cast<std::size_t>(v * model.width + u);
      inside += hits;
      (hits ? changed_inside : changed_outside) += std::abs(seen[at] - bare[at]) > 3;
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(changed_inside, inside * 8 / 10);
  EXPECT_EQ(changed_outside, 0);
}

/// Returns the middle of what is bright in some rows of a forward image.
Eigen::Vector2d brightest_in(const Image& image, int from_row, int to_row) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0.0;
  for (int v = from_row; v < to_row; ++v) {
    for (int u = 0; u < image.width; ++u) {
      if ((*image.pixels)[static_cast<std::size_t>(v * image.width + u)] < 100) continue;
      sum += Eigen::Vector2d(u, v);
      weight += 1.0;
    }
  }
  EXPECT_GT(weight, 10.0);
  return sum / weight;
}

/// Arranges two lamps straight ahead, one above the other in the image of a camera that looks up a little.
struct LampsAhead {
  explicit LampsAhead(double readout_s) : site(rolling_site(readout_s)) {
    site.lamps = {{14.0, 6.0, 5.0, 1.0}, {9.0, 6.0, 5.0, 1.0}};
    site.forward_camera.focal_px = 200.0;
    site.forward_camera.k1 = 0.0;
    site.forward_camera.pitch_rad = -0.4;
    site.forward_camera.exposes_itself = false;
  }
  Image look(const Twist& moving) const {
    const auto floor = std::make_shared<DottedFloor>();
    Moment moment = moment_at({4.0, 6.0, 0.0}, moving);
    moment.brightness = 0.15;
    return std::get<Image>(make_forward_camera(site, somebody(), floor, Photographed{}, Random(1))->look(moment));
  }
  Site site;
};

TEST(RollingShutter, ShearsWhatStandsUprightBeforeATurningCamera) {
  const Twist turning{0.0, 1.0};
  const Image image = LampsAhead(kReadoutS).look(turning);
  const LampsAhead subject(kReadoutS);
  CameraModel model;
  model.width = image.width;
  model.height = image.height;
  model.fx = model.fy = 200.0;
  model.cx = 159.5;
  model.cy = 119.5;
  const ForwardCameraSetup& setup = subject.site.forward_camera;
  model.robot_from_camera = downward_mount(setup.forward_m, 0.0, setup.height_m, setup.pitch_rad, 0.0, 0.0);
  const Moment moment = moment_at({4.0, 6.0, 0.0}, turning);
  // Against the image of a still camera: the middle of a large lamp's image is not the image of its middle.
  const Image still = subject.look({});
  const Pose3 site_from_camera = moment_at({4.0, 6.0, 0.0}, {}).site_from_camera(model.robot_from_camera, 0.0);
  const auto moved = [&](int from_row, int to_row) -> Eigen::Vector2d {
    return brightest_in(image, from_row, to_row) - brightest_in(still, from_row, to_row);
  };
  const auto expected = [&](const Eigen::Vector3d& lamp) -> Eigen::Vector2d {
    return pixel_in_its_row(moment, model, lamp) - pixel_of(model, site_from_camera, lamp);
  };
  const Eigen::Vector2d far = moved(80, 160);
  const Eigen::Vector2d near = moved(0, 80);
  EXPECT_LT((far - expected({14.0, 6.0, 5.0})).norm(), 0.5);
  EXPECT_LT(std::abs(near.x() - expected({9.0, 6.0, 5.0}).x()), 0.1)
      << "a shear is to the side: to a tenth of a pixel";
  EXPECT_GT(std::abs(far.x() - near.x()), 1.5) << "what stands one above the other is sheared";
}

TEST(RollingShutter, ChangesNothingAtRest) {
  const Moment still = moment_at({3.137, 2.071, 0.7}, {});
  Site site = rolling_site(0.0);
  site.boxes.push_back({Box::Kind::pillar, "pillar", {4.1, 2.9, 0.3}, 0.4, 0.4, 3.0});
  const Bytes at_once = floor_seen(site, still);
  site.disturbances.rolling_shutter_s = kReadoutS;
  EXPECT_EQ(at_once, floor_seen(site, still));
  EXPECT_NE(at_once, floor_seen(site, moment_at({3.137, 2.071, 0.7}, kRollingOn)));
  EXPECT_EQ(*LampsAhead(0.0).look({}).pixels, *LampsAhead(kReadoutS).look({}).pixels);
  EXPECT_NE(*LampsAhead(0.0).look(kRollingOn).pixels, *LampsAhead(kReadoutS).look(kRollingOn).pixels);
}

}  // namespace
}  // namespace weft::agents::sim
