#include "clients/evaluate/topometric/edge_errors.hpp"

#include <cmath>
#include <numbers>

namespace weft::evaluate::topometric {
namespace {

constexpr double kGrewM = 0.01;
constexpr double kWrongStitchM = 0.15;
constexpr double kWrongStitchRad = 4.0 * std::numbers::pi / 180.0;
constexpr double kBlindWayM = 0.1;

Pose2 true_relation(const Taught& taught, const EdgeId& edge) {
  return taught.site_from_place.at(edge.a).inverse() * taught.site_from_place.at(edge.b);
}

bool is_known(const Taught& taught, const EdgeId& edge) {
  return taught.site_from_place.contains(edge.a) && taught.site_from_place.contains(edge.b);
}

/// Returns how far a relation is off, in the frame of the place it leads to: x along the way, y across.
Eigen::Vector2d off_truth(const Relation& said, const Pose2& truth) {
  return (truth.inverse() * planar(said)).translation();
}

/// Returns the metres truly driven without seeing, up to each place that a run has kept.
std::map<PlaceId, double> blind_metres(const Run& run) {
  std::map<PlaceId, double> blind_m;
  double sum_m = 0.0;
  for (std::size_t i = 0; i < run.moments.size(); ++i) {
    const Moment& now = run.moments[i];
    if (i > 0 && !now.seen && now.blind_reason != "dropped_frame")
      sum_m += (now.site_from_robot.translation() - run.moments[i - 1].site_from_robot.translation()).norm();
    if (now.kept) blind_m[*now.kept] = sum_m;
  }
  return blind_m;
}

}  // namespace

EdgeErrors chain_errors(const Taught& taught) {
  EdgeErrors errors;
  for (const auto& [id, experience] : taught.map.snapshot().experiences()) {
    const Experience* const before = taught.unregistered.snapshot().experience(id);
    for (const Edge& edge : experience->chain) {
      const Edge* const guessed = before == nullptr ? nullptr : before->hop(edge.id.a.index);
      if (guessed == nullptr || !is_known(taught, edge.id) || identical(guessed->a_from_b, edge.a_from_b)) continue;
      const Pose2 truth = true_relation(taught, edge.id);
      const Eigen::Vector2d off = off_truth(edge.a_from_b, truth);
      const Eigen::Vector2d off_before = off_truth(guessed->a_from_b, truth);
      errors.along_m.push_back(std::abs(off.x()));
      errors.across_m.push_back(std::abs(off.y()));
      errors.along_before_m.push_back(std::abs(off_before.x()));
      errors.across_before_m.push_back(std::abs(off_before.y()));
      errors.grew += off.norm() > off_before.norm() + kGrewM ? 1.0 : 0.0;
      errors.edges += 1.0;
    }
  }
  return errors;
}

StitchErrors stitch_errors(const Taught& taught) {
  StitchErrors errors;
  for (const auto& [id, experience] : taught.map.snapshot().experiences()) {
    for (const Edge& edge : experience->stitches) {
      // A stitch between runs stands in both; one without inliers is a way that is free, not a place seen again.
      if (edge.id.b.experience != id || edge.inliers == 0 || !is_known(taught, edge.id)) continue;
      const Pose2 off = true_relation(taught, edge.id).inverse() * planar(edge.a_from_b);
      const double metres = off.translation().norm();
      const double radians = std::abs(off.heading);
      errors.wrong += metres > kWrongStitchM || radians > kWrongStitchRad ? 1.0 : 0.0;
      if (edge.id.a.experience == id) continue;
      errors.metres.push_back(metres);
      errors.radians.push_back(radians);
    }
  }
  return errors;
}

double unmarked_blind_edges(const Taught& taught) {
  double unmarked = 0.0;
  for (const Run& run : taught.runs) {
    const std::map<PlaceId, double> blind_m = blind_metres(run);
    const Experience* const experience = taught.map.snapshot().experience(run.experience);
    if (experience == nullptr) continue;
    for (const Edge& edge : experience->chain) {
      const auto a = blind_m.find(edge.id.a);
      const auto b = blind_m.find(edge.id.b);
      if (a == blind_m.end() || b == blind_m.end()) continue;
      if (b->second - a->second > kBlindWayM && edge.origin != Origin::blind) unmarked += 1.0;
    }
  }
  return unmarked;
}

}  // namespace weft::evaluate::topometric
