#pragma once
// A ceiling with things that hang below it, rendered by rays: no homography, no code of the method.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/motion.hpp"
#include "agents/perception/view.hpp"
#include "core/random.hpp"

namespace weft::test {

/// Returns a camera that looks up, leaning ahead by `pitch_rad` and to the right by `roll_rad`.
inline agents::CameraModel up_camera(double pitch_rad = 0.0, double roll_rad = 0.0, double height_m = 0.6) {
  Eigen::Matrix3d up;
  up.col(0) = -Eigen::Vector3d::UnitY();  // the image's right is the robot's
  up.col(1) = Eigen::Vector3d::UnitX();
  up.col(2) = Eigen::Vector3d::UnitZ();
  const Eigen::Quaterniond lean(Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()));
  agents::CameraModel camera;
  camera.id = "up";
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 300.0;
  camera.cx = 322.0;
  camera.cy = 237.0;
  camera.distortion = {-0.05, 0.01, 0.0, 0.0, 0.0};
  camera.robot_from_camera = {(lean * Eigen::Quaterniond(up)).normalized(), {0.1, 0.02, height_m}};
  return camera;
}

/// Holds a level rectangle with a pattern of rectangles, or a lamp.
struct Panel {
  double height_m = 0.0;
  Eigen::AlignedBox2d box;
  bool is_lamp = false;
  double px_m = 0.01;
  int columns = 0;
  std::vector<std::uint8_t> greys = {};

  double at(const Eigen::Vector2d& point) const {
    if (is_lamp) return 255.0;
    const Eigen::Vector2d p = (point - box.min()) / px_m - Eigen::Vector2d::Constant(0.5);
    const int rows = static_cast<int>(greys.size()) / columns;
    const int x = std::clamp(static_cast<int>(std::floor(p.x())), 0, columns - 2);
    const int y = std::clamp(static_cast<int>(std::floor(p.y())), 0, rows - 2);
    const double u = std::clamp(p.x() - x, 0.0, 1.0);
    const double v = std::clamp(p.y() - y, 0.0, 1.0);
    const auto grey = [&](int c, int r) {
      return static_cast<double>(
          greys[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c)]);
    };
    return (1 - v) * ((1 - u) * grey(x, y) + u * grey(x + 1, y)) +
           v * ((1 - u) * grey(x, y + 1) + u * grey(x + 1, y + 1));
  }
};

/// Returns a panel with `per_m2` rectangles a square metre.
inline Panel patterned(double height_m, const Eigen::AlignedBox2d& box, std::uint64_t seed, double per_m2 = 6.0) {
  Panel panel{height_m, box};
  panel.columns = static_cast<int>(box.sizes().x() / panel.px_m) + 1;
  const int rows = static_cast<int>(box.sizes().y() / panel.px_m) + 1;
  panel.greys.assign(static_cast<std::size_t>(panel.columns) * static_cast<std::size_t>(rows), 120);
  Random random(seed);
  const int count = static_cast<int>(per_m2 * box.volume());
  for (int i = 0; i < count; ++i) {
    const int left = static_cast<int>(random.below(static_cast<std::uint64_t>(panel.columns)));
    const int top = static_cast<int>(random.below(static_cast<std::uint64_t>(rows)));
    const int width = 8 + static_cast<int>(random.below(50));
    const int height = 8 + static_cast<int>(random.below(50));
    const auto grey = static_cast<std::uint8_t>(50 + random.below(150));
    for (int r = top; r < std::min(rows, top + height); ++r)
      for (int c = left; c < std::min(panel.columns, left + width); ++c)
        panel.greys[static_cast<std::size_t>(r) * static_cast<std::size_t>(panel.columns) +
                    static_cast<std::size_t>(c)] = grey;
  }
  return panel;
}

/// Renders views of panels; the lowest hides what is above it.
class RenderedCeiling {
 public:
  std::vector<Panel> panels;
  double beside_grey = 90.0;  ///< where there is no panel

  agents::View view(const agents::CameraModel& camera, const Pose2& map_from_robot, const agents::Attitude& attitude,
                    std::uint64_t seed) {
    if (rays_.empty() || seen_by_.fx != camera.fx || seen_by_.lens != camera.lens) make_rays(camera);
    std::vector<const Panel*> order;
    for (const Panel& panel : panels) order.push_back(&panel);
    std::stable_sort(order.begin(), order.end(),
                     [](const Panel* a, const Panel* b) { return a->height_m < b->height_m; });
    const Pose3 map_from_camera = lift(map_from_robot) * agents::level_from_body(attitude) * camera.robot_from_camera;
    const Eigen::Matrix3d turned = map_from_camera.rotation.toRotationMatrix();
    const Eigen::Vector3d& eye = map_from_camera.translation;
    Random random(seed);
    auto pixels = std::make_shared<Bytes>(rays_.size() / kSamples);
    for (std::size_t i = 0; i < pixels->size(); ++i) {
      double sum = 0.0;
      for (std::size_t k = 0; k < kSamples; ++k) sum += grey(order, eye, turned * rays_[kSamples * i + k]);
      const double noisy = sum / kSamples + random.uniform(-3.0, 3.0);
      (*pixels)[i] =
          static_cast<std::uint8_t>(std::clamp(std::lround(sum > 254.0 * kSamples ? 255.0 : noisy), 0L, 255L));
    }
    agents::View out;
    out.frame = seed;
    out.sensor = camera.id;
    out.data = agents::Image{camera.width, camera.height, pixels};
    return out;
  }

 private:
  static constexpr std::size_t kSamples = 2;  // rays of a pixel

  void make_rays(const agents::CameraModel& camera) {
    seen_by_ = camera;
    rays_.clear();
    for (int row = 0; row < camera.height; ++row)
      for (int column = 0; column < camera.width; ++column)
        for (const double aside : {-0.25, 0.25})
          rays_.push_back(
              agents::normalised_from_pixel(camera, Eigen::Vector2d(column + aside, row + aside)).homogeneous());
  }

  double grey(const std::vector<const Panel*>& order, const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const {
    if (ray.z() <= 1e-3) return beside_grey;
    for (const Panel* panel : order) {
      const Eigen::Vector2d at = (eye + (panel->height_m - eye.z()) / ray.z() * ray).head<2>();
      if (panel->box.contains(at)) return panel->at(at);
    }
    return beside_grey;
  }

  agents::CameraModel seen_by_;
  std::vector<Eigen::Vector3d> rays_;
};

inline Eigen::AlignedBox2d box(double x, double y, double width, double height) {
  return {Eigen::Vector2d(x, y), Eigen::Vector2d(x + width, y + height)};
}

/// Returns a ceiling with a pattern all over, beams and ducts 0.5 and 1.1 m below it, and some lamps 0.9 m below.
inline RenderedCeiling hall_ceiling(double ceiling_m, std::uint64_t seed = 1) {
  RenderedCeiling hall;
  hall.panels.push_back(patterned(ceiling_m, box(-10.0, -10.0, 26.0, 20.0), seed));
  for (const double x : {-4.0, 1.0, 6.0})
    hall.panels.push_back(patterned(ceiling_m - 0.5, box(x, -9.0, 0.4, 18.0), seed + 7, 12.0));
  hall.panels.push_back(patterned(ceiling_m - 1.1, box(-9.0, 1.5, 22.0, 0.6), seed + 9, 12.0));
  for (const double x : {-2.0, 2.0, 6.0, 10.0})
    hall.panels.push_back({ceiling_m - 0.9, box(x, -1.8, 1.2, 0.3), true});
  return hall;
}

}  // namespace weft::test
