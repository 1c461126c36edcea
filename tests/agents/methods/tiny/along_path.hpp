#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/marks.hpp"

namespace weft::agents::tiny {

/// Knows distance and heading only: no pose is ever known. The heading shift is that of the bearings of marks ahead,
/// so a robot beside the path sees itself turned, and steering by it brings it back.
class AlongThePath {
 public:
  static constexpr std::string_view name = "along-the-path";
  static constexpr std::uint32_t content_format = 1;
  using Content = MarksMethod::Content;
  using Odometry = MarksMethod::Odometry;

  Step observe(Odometry& odometry, const View* view, const Motion& motion) const {
    // Vision gives the turn, wheels the distance.
    Step step = marks_.observe(odometry, view, motion);
    const Pose2 moved = planar(step.previous_from_current);
    const double driven = motion.wheels ? motion.wheels->distance_m : moved.x;
    const double sigma_m = 0.03 * std::abs(driven);
    const double sigma_rad = 0.03 * (std::abs(moved.heading) + std::abs(driven));
    step.previous_from_current = AlongPath{driven, sigma_m * sigma_m, moved.heading, sigma_rad * sigma_rad};
    return step;
  }
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const {
    return marks_.extract(odometry, view);
  }
  Bytes encode(const Content& content) const { return marks_.encode(content); }
  Result<Content> decode(ByteView bytes) const { return marks_.decode(bytes); }
  std::optional<Signature> sign(const Content&) const { return std::nullopt; }

  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>&) const {
    std::vector<double> nearer_m;
    std::vector<double> turned_rad;
    for (const Marks::Sighting& one : a.sightings) {
      for (const Marks::Sighting& other : b.sightings) {
        if (one.mark != other.mark) continue;
        const Pose2& in_a = one.robot_from_mark;
        const Pose2& in_b = other.robot_from_mark;
        constexpr double ahead_m = 0.35;
        if (in_a.x < ahead_m || in_b.x < ahead_m) continue;
        nearer_m.push_back(std::hypot(in_a.x, in_a.y) - std::hypot(in_b.x, in_b.y));
        turned_rad.push_back(wrap_angle(std::atan2(in_a.y, in_a.x) - std::atan2(in_b.y, in_b.x)));
      }
    }
    constexpr std::size_t least = 3;
    if (turned_rad.size() < least) {
      return tl::unexpected(Refusal{"few_bearings", static_cast<double>(turned_rad.size()), least});
    }
    const double shift = median(turned_rad);
    constexpr double most_rad = 0.8;
    if (std::abs(shift) > most_rad) return tl::unexpected(Refusal{"turned_too_far", std::abs(shift), most_rad});
    Related related;
    related.a_from_b = AlongPath{median(nearer_m), 0.04 * 0.04, shift, 0.03 * 0.03};
    related.inliers = static_cast<std::uint32_t>(turned_rad.size());
    related.overlap = std::min(1.0, static_cast<double>(turned_rad.size()) / static_cast<double>(b.sightings.size()));
    return related;
  }

 private:
  static double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  MarksMethod marks_;
};

static_assert(Method<AlongThePath> && !ChartsItself<AlongThePath>);

}  // namespace weft::agents::tiny
