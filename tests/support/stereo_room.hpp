#pragma once
// A room for tests of what sees in stereo: walls, floor and boxes with known distances, seen through a known pair.
// Not the simulated camera of agents/bodies/sim, on purpose: a mistake would have to be made twice.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/rig.hpp"
#include "agents/perception/view.hpp"
#include "core/geometry/pose3.hpp"
#include "core/random.hpp"

namespace weft::test {

/// Describes an axis-aligned block; the room itself is one seen from inside.
struct Block {
  Eigen::Vector3d low, high;
  double contrast = 45.0;  ///< grey levels of its texture, RMS
  double grey = 110.0;
};

/// Describes what differs between two looks.
struct StereoShot {
  double gain = 1.0;
  double noise = 1.5;  ///< grey levels
  std::uint64_t seed = 1;
};

/// Is an image with the depth of each pixel along the camera's axis.
struct SeenDepth {
  agents::Image image;
  std::vector<double> depth_m;
};

class StereoRoom {
 public:
  /// Makes a room of `inside` with blocks in it; texture of all sizes from 0.8 m down, drawn from the seed.
  StereoRoom(std::uint64_t seed, Block inside, std::vector<Block> blocks = {})
      : inside_(std::move(inside)), blocks_(std::move(blocks)), texels_(kSide * kSide) {
    Random random(seed);
    for (float& texel : texels_) texel = static_cast<float>(random.uniform(-1.0, 1.0));
  }

  SeenDepth look(const agents::CameraModel& camera, const Pose3& room_from_camera,
                 const StereoShot& shot = {}) const {
    SeenDepth seen;
    Bytes pixels;
    Random noise(shot.seed);
    const double footprint = 1.0 / camera.fx;
    for (int v = 0; v < camera.height; ++v)
      for (int u = 0; u < camera.width; ++u) {
        double grey = 0.0;
        for (const auto& [du, dv] : {std::pair{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}})
          grey += 0.25 * met(camera, room_from_camera, {u + du, v + dv}, footprint).grey;
        grey = shot.gain * grey + shot.noise * noise.normal();
        pixels.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(grey), 0L, 255L)));
        seen.depth_m.push_back(met(camera, room_from_camera, Eigen::Vector2d(u, v), footprint).depth_m);
      }
    seen.image = {camera.width, camera.height, std::make_shared<const Bytes>(std::move(pixels))};
    return seen;
  }

  /// Returns the pair that a sensor sees from there.
  agents::StereoPair pair(const agents::Sensor& sensor, const Pose3& room_from_robot, StereoShot shot = {}) const {
    agents::StereoPair pair;
    pair.left = look(sensor.camera, room_from_robot * sensor.camera.robot_from_camera, shot).image;
    shot.seed += 7919;
    pair.right = look(*sensor.right, room_from_robot * sensor.right->robot_from_camera, shot).image;
    return pair;
  }

 private:
  static constexpr std::size_t kSide = 256;
  static constexpr int kSizes = 7;  // of texture: 0.8, 0.4, ... 0.0125 m

  struct Met {
    double depth_m = 0.0;
    double grey = 0.0;
  };

  Met met(const agents::CameraModel& camera, const Pose3& room_from_camera, const Eigen::Vector2d& pixel,
          double footprint) const {
    const Eigen::Vector3d ray = agents::normalised_from_pixel(camera, pixel).homogeneous();
    const Eigen::Vector3d way = room_from_camera.rotation * ray;
    const Eigen::Vector3d& from = room_from_camera.translation;
    const Block* block = &inside_;
    double depth = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
      if (way(axis) != 0.0)
        depth = std::min(depth, ((way(axis) > 0.0 ? inside_.high : inside_.low)(axis)-from(axis)) / way(axis));
    for (const Block& one : blocks_) {
      double enters = 0.0;
      double leaves = depth;
      for (int axis = 0; axis < 3; ++axis) {
        const double a = (one.low(axis) - from(axis)) / way(axis);
        const double b = (one.high(axis) - from(axis)) / way(axis);
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
      }
      if (enters <= 0.0 || enters >= leaves) continue;
      depth = enters;
      block = &one;
    }
    const Eigen::Vector3d at = from + depth * way;
    return {depth, block->grey + block->contrast * texture(*block, at, depth * footprint)};
  }

  /// Returns the texture of the face that the point lies on: noise of several sizes, of which those that a pixel does
  /// not resolve fade.
  double texture(const Block& block, const Eigen::Vector3d& at, double pixel_m) const {
    int face = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 6; ++side) {
      const double off = std::abs(at(side % 3) - (side < 3 ? block.low : block.high)(side % 3));
      if (off < nearest) {
        nearest = off;
        face = side;
      }
    }
    const double u = at((face + 1) % 3) + 3.7 * face + 1.3 * block.low.x();
    const double v = at((face + 2) % 3) + 1.9 * face + 2.1 * block.low.y();
    double sum = 0.0;
    double size = 0.8;
    for (int i = 0; i < kSizes; ++i, size *= 0.5)
      sum += std::clamp(0.5 * size / pixel_m - 0.5, 0.0, 1.0) * texel(u / size + 17.0 * i, v / size + 31.0 * i);
    return sum;
  }

  double texel(double u, double v) const {
    const double left = std::floor(u);
    const double top = std::floor(v);
    const auto at = [&](double column, double row) {
      return texels_[(static_cast<std::size_t>(static_cast<std::int64_t>(row)) % kSide) * kSide +
                     static_cast<std::size_t>(static_cast<std::int64_t>(column)) % kSide];
    };
    const double s = u - left;
    const double t = v - top;
    return (1.0 - t) * ((1.0 - s) * at(left, top) + s * at(left + 1, top)) +
           t * ((1.0 - s) * at(left, top + 1) + s * at(left + 1, top + 1));
  }

  Block inside_;
  std::vector<Block> blocks_;
  std::vector<float> texels_;
};

/// Returns an image of that size that is one grey: what a covered lens shows.
inline agents::Image filled(const agents::Image& like, std::uint8_t grey) {
  return {like.width, like.height, std::make_shared<const Bytes>(like.pixels->size(), grey)};
}

/// Returns a rectified pair `baseline_m` wide that looks ahead from the middle, 0.45 m above the floor.
inline agents::Sensor stereo_sensor(int width, int height, double focal_px, double baseline_m) {
  agents::Sensor sensor;
  sensor.id = "stereo";
  sensor.kind = agents::SensorKind::stereo;
  sensor.camera.id = "left";
  sensor.camera.width = width;
  sensor.camera.height = height;
  sensor.camera.fx = sensor.camera.fy = focal_px;
  sensor.camera.cx = 0.5 * (width - 1);
  sensor.camera.cy = 0.5 * (height - 1);
  sensor.camera.robot_from_camera = agents::downward_mount(0.1, 0.5 * baseline_m, 0.45, 0.1, 0.0, 0.0);
  sensor.right = sensor.camera;
  sensor.right->id = "right";
  sensor.right->robot_from_camera =
      sensor.camera.robot_from_camera * Pose3{Eigen::Quaterniond::Identity(), {baseline_m, 0.0, 0.0}};
  return sensor;
}

/// Returns a hall of 9 x 6 m with crates at several distances; the robot begins at (1, 0) and looks along x.
inline StereoRoom crate_room(std::uint64_t seed = 3, double contrast = 45.0) {
  const auto block = [&](double x, double y, double side, double grey) {
    return Block{{x, y, 0.0}, {x + side, y + side, 0.8 * side + 0.2}, contrast, grey};
  };
  return {seed,
          {{-1.0, -3.0, 0.0}, {8.0, 3.0, 3.0}, contrast, 120.0},
          {block(3.0, 0.7, 0.5, 90.0), block(2.6, -1.2, 0.4, 140.0), block(4.5, -0.6, 0.9, 110.0),
           block(5.5, 1.0, 1.0, 100.0), block(6.5, -2.2, 0.7, 130.0)}};
}

}  // namespace weft::test
