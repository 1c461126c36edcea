#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "agents/methods/topometric/topometric.hpp"
#include "core/random.hpp"
#include "tests/support/stereo_room.hpp"

namespace weft::agents {

/// Makes up a level site of upright walls and of landmarks on them, and what a pair that looks ahead sees of it from
/// anywhere: no pictures, but points with the noise of depths.
class MadeSite {
 public:
  struct Wall {
    Eigen::Vector2d from, to;
    double high_m = 1.4;
  };
  struct Landmark {
    Eigen::Vector3d at;
    Descriptor descriptor;
  };
  static constexpr double kRangeM = 5.0;
  static constexpr double kHalfViewRad = 0.65;
  static constexpr double kSigmaBySquare = 0.008;  // 1/m, of a depth
  static constexpr double kFocalPx = 208.0;

  std::vector<Wall> walls;
  std::vector<Landmark> landmarks;

  void add_box(double x0, double y0, double x1, double y1) {
    walls.push_back({{x0, y0}, {x1, y0}});
    walls.push_back({{x1, y0}, {x1, y1}});
    walls.push_back({{x1, y1}, {x0, y1}});
    walls.push_back({{x0, y1}, {x0, y0}});
  }
  /// Sticks landmarks to all walls, `apart_m` from each other.
  void add_landmarks(double apart_m, std::uint64_t seed) {
    Random random(seed);
    for (const Wall& wall : walls) {
      const double length_m = (wall.to - wall.from).norm();
      for (double at_m = 0.5 * apart_m; at_m < length_m; at_m += apart_m) {
        const Eigen::Vector2d foot = wall.from + (wall.to - wall.from) * (at_m / length_m);
        landmarks.push_back({{foot.x(), foot.y(), random.uniform(0.2, 1.3)},
                             {random.next(), random.next(), random.next(), random.next()}});
      }
    }
  }

  /// Returns how far it is to a wall; infinity where there is none.
  double free_m(const Eigen::Vector2d& from, double heading) const {
    const Eigen::Vector2d ray(std::cos(heading), std::sin(heading));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) {
      const Eigen::Vector2d along = wall.to - wall.from;
      const double cross = ray.x() * along.y() - ray.y() * along.x();
      if (std::abs(cross) < 1e-9) continue;
      const Eigen::Vector2d off = wall.from - from;
      const double range = (off.x() * along.y() - off.y() * along.x()) / cross;
      const double share = (off.x() * ray.y() - off.y() * ray.x()) / cross;
      if (range > 0.0 && share >= 0.0 && share <= 1.0) nearest = std::min(nearest, range);
    }
    return nearest;
  }
  /// Returns the distance to the nearest wall.
  double room_m(const Eigen::Vector2d& at) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) {
      const Eigen::Vector2d along = wall.to - wall.from;
      const double share = std::clamp((at - wall.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (at - wall.from - share * along).norm());
    }
    return nearest;
  }

  Scan scan_from(const Pose2& site_from_robot, Random& random) const {
    Scan scan;
    for (double bearing = -kHalfViewRad; bearing <= kHalfViewRad; bearing += 0.0087) {
      const double range = free_m(site_from_robot.translation(), site_from_robot.heading + bearing);
      Beam beam{bearing, 0.0, 0.0, std::min(range, kRangeM), Beam::Return::none};
      if (range < kRangeM) {
        beam.sigma_m = kSigmaBySquare * range * range;
        beam.range_m = range + random.normal(0.0, beam.sigma_m);
        beam.clear_m = beam.range_m;
        beam.kind = Beam::Return::obstacle;
      }
      scan.beams.push_back(beam);
    }
    return scan;
  }

  std::vector<SpaceFeature> features_from(const Pose2& site_from_robot, Random& random) const {
    std::vector<SpaceFeature> features;
    for (const Landmark& landmark : landmarks) {
      const Eigen::Vector2d at = site_from_robot.inverse() * Eigen::Vector2d(landmark.at.head<2>());
      const double range = at.norm();
      const double bearing = std::atan2(at.y(), at.x());
      if (range > kRangeM || range < 0.5 || std::abs(bearing) > kHalfViewRad) continue;
      if (free_m(site_from_robot.translation(), site_from_robot.heading + bearing) < range - 0.05) continue;
      SpaceFeature feature;
      const double sigma = kSigmaBySquare * range * range;
      const double scale = 1.0 + random.normal(0.0, sigma) / range;
      const Eigen::Vector2d seen =
          Eigen::Rotation2Dd(random.normal(0.0, 0.5 / kFocalPx)) * Eigen::Vector2d(scale * at);
      feature.in_place = Eigen::Vector3d(seen.x(), seen.y(), landmark.at.z()).cast<float>();
      feature.depth_sigma_m = static_cast<float>(sigma);
      feature.descriptor = landmark.descriptor;
      feature.descriptor[random.below(4)] ^= 1ULL << random.below(64);
      features.push_back(feature);
    }
    return features;
  }

  /// Returns what a place stores whose robot came to it straight, a metre behind it first.
  TopometricContent content_at(const Pose2& site_from_place, Random& random) const {
    TopometricContent content;
    content.rig.focal_px = kFocalPx;
    content.rig.baseline_m = 0.12;
    content.floor.points = 1000;
    constexpr int frames = 8;
    for (int frame = 0; frame < frames; ++frame) {
      const Pose2 place_from_frame{-0.12 * (frames - 1 - frame), 0.0, 0.0};
      content.cloud.place_from_frames.push_back(lift(place_from_frame));
      content.cloud.cameras.push_back(
          Eigen::Vector3d(place_from_frame.x, place_from_frame.y, kCameraM).cast<float>());
      add_frame(site_from_place, place_from_frame, static_cast<std::uint16_t>(frame), random, content.cloud);
    }
    content.features = features_from(site_from_place, random);
    return content;
  }
  /// Returns what a view shows.
  TopometricContent view_from(const Pose2& site_from_robot, Random& random) const {
    TopometricContent seen;
    seen.rig.focal_px = kFocalPx;
    seen.floor.points = 1000;
    seen.scan = scan_from(site_from_robot, random);
    seen.features = features_from(site_from_robot, random);
    return seen;
  }

 private:
  static constexpr double kCameraM = 0.6;  // above the floor

  void add_frame(const Pose2& site_from_place, const Pose2& place_from_frame, std::uint16_t frame, Random& random,
                 PlaceCloud& cloud) const {
    const Pose2 site_from_frame = site_from_place * place_from_frame;
    const auto add = [&](double bearing, double range, double z) {
      const double sigma = kSigmaBySquare * range * range;
      const double seen = range + random.normal(0.0, sigma);
      const Eigen::Vector2d at =
          place_from_frame * Eigen::Vector2d(seen * std::cos(bearing), seen * std::sin(bearing));
      cloud.points.emplace_back(static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(z));
      cloud.frames.push_back(frame);
    };
    for (double bearing = -kHalfViewRad; bearing <= kHalfViewRad; bearing += 0.012) {
      const double wall = free_m(site_from_frame.translation(), site_from_frame.heading + bearing);
      for (double range = 1.0; range < std::min(wall - 0.02, kRangeM); range += 0.25)
        add(bearing, range, random.normal(0.0, 0.01));
      if (wall < kRangeM)
        for (double z = 0.1; z < 1.4; z += 0.2) add(bearing, wall, z);
    }
  }
};

/// Teaches places along a way: centres of charts and what they are made of.
struct TaughtSite {
  std::vector<Pose2> site_from_places;
  std::vector<std::shared_ptr<const TopometricContent>> contents;

  static PlaceId id(std::size_t i) { return {ExperienceId{7}, static_cast<std::uint32_t>(i)}; }
  void teach(const MadeSite& site, const Pose2& site_from_place, Random& random) {
    site_from_places.push_back(site_from_place);
    contents.push_back(std::make_shared<const TopometricContent>(site.content_at(site_from_place, random)));
  }
  /// Teaches every half metre of a straight way.
  void teach_straight(const MadeSite& site, const Pose2& from, double length_m, Random& random) {
    for (double at_m = 0.0; at_m <= length_m + 1e-9; at_m += 0.5) teach(site, from * Pose2{at_m, 0.0, 0.0}, random);
  }
  /// Returns what a chart about a place is made of: those up to 12 hops away, `missing` of them without content.
  std::vector<ChartPlace<TopometricContent>> around(std::size_t centre,
                                                    const std::vector<std::size_t>& missing = {}) const {
    std::vector<ChartPlace<TopometricContent>> places;
    for (std::size_t i = 0; i < site_from_places.size(); ++i) {
      const std::size_t depth = i > centre ? i - centre : centre - i;
      if (depth > Topometric::chart_size.hops) continue;
      const bool is_missing = std::find(missing.begin(), missing.end(), i) != missing.end();
      places.push_back({id(i), static_cast<std::uint32_t>(depth),
                        Metric3{lift(site_from_places[centre].inverse() * site_from_places[i]), {}},
                        is_missing ? nullptr : contents[i]});
    }
    return places;
  }
};

inline Topometric made_method(const TopometricConfig& config = {}) {
  return *Topometric::make(config, Rig{{test::stereo_sensor(320, 240, MadeSite::kFocalPx, 0.12)}});
}

/// Returns a room 9 by 6 m with a cupboard, a shelf and a pillar.
inline MadeSite furnished_room() {
  MadeSite site;
  site.add_box(-1.0, -3.0, 8.0, 3.0);
  site.add_box(2.0, 2.4, 3.2, 3.0);
  site.add_box(5.0, -3.0, 5.8, -2.2);
  site.add_box(6.2, 1.4, 6.6, 1.8);
  site.add_box(-1.0, -3.0, 0.0, -2.5);
  site.add_landmarks(0.25, 11);
  return site;
}

/// Returns a corridor 1.8 m wide along x, from -20 to 20 m, without relief.
inline MadeSite bare_corridor() {
  MadeSite site;
  site.walls.push_back({{-20.0, 0.9}, {20.0, 0.9}});
  site.walls.push_back({{-20.0, -0.9}, {20.0, -0.9}});
  return site;
}

}  // namespace weft::agents
