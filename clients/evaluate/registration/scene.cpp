#include "clients/evaluate/registration/scene.hpp"

#include <algorithm>
#include <cmath>

namespace weft::evaluate::registration {
namespace {

constexpr double kHighM = 3.0;
constexpr double kThickM = 0.2;

SceneBox box_at(double x, double y, double width, double depth, double height, double seen) {
  return {{x - 0.5 * width, y - 0.5 * depth, 0.0}, {x + 0.5 * width, y + 0.5 * depth, height}, seen};
}

/// Adds floor and four walls around [0, length] x [-half_width, half_width].
void enclose(Scene& scene, double length, double half_width, double walls_seen) {
  const double outer = half_width + kThickM;
  scene.boxes.push_back({{-1.0, -outer, -kThickM}, {length + 1.0, outer, 0.0}, 0.9});
  scene.boxes.push_back({{-1.0, half_width, 0.0}, {length + 1.0, outer, kHighM}, walls_seen});
  scene.boxes.push_back({{-1.0, -outer, 0.0}, {length + 1.0, -half_width, kHighM}, walls_seen});
  scene.boxes.push_back({{length, -outer, 0.0}, {length + kThickM, outer, kHighM}, walls_seen});
  scene.boxes.push_back({{-kThickM, -outer, 0.0}, {0.0, outer, kHighM}, walls_seen});
}

Scene made_room(Random& random) {
  Scene scene;
  const double length = random.uniform(8.0, 13.0);
  const double half_width = random.uniform(2.0, 4.0);
  enclose(scene, length, half_width, random.uniform(0.4, 0.9));
  const std::uint64_t things = 6 + random.below(8);
  for (std::uint64_t thing = 0; thing < things; ++thing) {
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double y = side * random.uniform(1.0, half_width);
    const double size = random.uniform(0.2, 1.0);
    scene.boxes.push_back(
        box_at(random.uniform(1.0, length), y, size, random.uniform(0.2, 0.9), random.uniform(0.3, 2.2), 0.8));
  }
  scene.start = {1.0, random.uniform(-0.4, 0.4), random.uniform(-0.1, 0.1)};
  scene.length_m = length - 3.5;
  return scene;
}

Scene made_aisle(Random& random, bool is_plain) {
  Scene scene;
  const double length = 30.0;
  enclose(scene, length, 1.0, random.uniform(0.3, 0.8));
  for (const double side : {1.0, -1.0}) {
    for (double x = random.uniform(0.0, 3.0); x < length && !is_plain; x += random.uniform(3.0, 6.0)) {
      scene.boxes.push_back(box_at(x, side * 0.925, random.uniform(0.2, 0.5), 0.15, kHighM, 0.8));
    }
    for (double x = random.uniform(2.0, 9.0); x < length && !is_plain; x += random.uniform(5.0, 12.0)) {
      scene.boxes.push_back(box_at(x, side * 0.8, random.uniform(0.3, 0.6), 0.4, random.uniform(0.3, 1.0), 0.8));
    }
  }
  scene.start = {9.0, random.uniform(-0.2, 0.2), random.uniform(-0.02, 0.02)};
  scene.length_m = 8.0;  // far from either end
  return scene;
}

/// Returns where a ray enters a box that it does not begin in, in lengths of the ray; none: it misses.
std::optional<double> entry(const SceneBox& box, const Eigen::Vector3d& from, const Eigen::Vector3d& inverse) {
  const Eigen::Array3d first = (box.low - from).array() * inverse.array();
  const Eigen::Array3d second = (box.high - from).array() * inverse.array();
  const double in = first.min(second).maxCoeff();
  const double out = first.max(second).minCoeff();
  if (in > out || in <= 0.0) return std::nullopt;
  return in;
}

}  // namespace

std::string_view name_of(SceneKind kind) {
  switch (kind) {
    case SceneKind::room:
      return "room";
    case SceneKind::aisle:
      return "aisle";
    case SceneKind::plain:
      return "plain";
  }
  return "";
}

Scene made_scene(SceneKind kind, Random& random) {
  return kind == SceneKind::room ? made_room(random) : made_aisle(random, kind == SceneKind::plain);
}

std::optional<Met> first_met(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& ray,
                             double most) {
  const Eigen::Vector3d inverse = ray.cwiseInverse();
  std::optional<Met> met;
  for (std::size_t at = 0; at < scene.boxes.size(); ++at) {
    const auto in = entry(scene.boxes[at], from, inverse);
    if (!in || *in > most) continue;
    most = *in;
    met = Met{*in, at};
  }
  return met;
}

}  // namespace weft::evaluate::registration
