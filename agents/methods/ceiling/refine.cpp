#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/perception/plane/guided_match.hpp"
#include "agents/perception/plane/level_points.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kPlacesAPiece = 8;
constexpr std::array<std::size_t, 4> kPlacesBack = {1, 2, 4, 8};  // a corner is found again that one place misses

/// Bounds the pieces of the adjustment: the more poses a run has, the longer an iteration over all of them takes.
MosaicAdjustmentConfig bounds_for(std::size_t places) {
  constexpr std::size_t places_times_iterations = 1000;  // of one piece
  constexpr std::uint32_t iterations = 30;               // of all pieces
  MosaicAdjustmentConfig config;
  config.graph_iterations = std::clamp<std::uint32_t>(
      static_cast<std::uint32_t>(places_times_iterations / std::max<std::size_t>(places, 1)), 1, 3);
  config.graph_pieces = iterations / config.graph_iterations;
  config.points_each = 250;
  return config;
}

std::size_t features_in(const CeilingRun& run) {
  return std::accumulate(run.begin(), run.end(), std::size_t{0},
                         [](std::size_t sum, const auto& place) { return sum + place.content->features.size(); });
}

/// Returns by how much features of two places may lie apart that show one corner: by their own noise, and by what of
/// the way between both a height that is not known makes.
double most_apart_m(const CeilingConfig& config, const CeilingContent& content, const Pose2& a_from_b) {
  constexpr double of_way = 0.03;
  return config.consensus_px * metres_per_pixel(config, content.ceiling_m) + of_way * a_from_b.translation().norm();
}

/// Returns the features of place b that odometry puts on like ones of place a.
std::vector<Match> matches_by_odometry(const CeilingConfig& config, const CeilingRefinement& refinement,
                                       std::size_t a, std::size_t b, const Relation& a_from_b) {
  const CeilingContent& content_a = *refinement.run[a].content;
  const CeilingContent& content_b = *refinement.run[b].content;
  const Pose2 pose = planar(a_from_b);
  const Eigen::Matrix3d covariance = planar_covariance(a_from_b);
  const double within = most_apart_m(config, content_b, pose);
  const MatchGate gate{
      pose, std::min(3.0 * std::sqrt(std::max({covariance(0, 0), covariance(1, 1), 0.0})), config.widest_gate_m),
      std::min(3.0 * std::sqrt(std::max(covariance(2, 2), 0.0)), config.gate_rad)};
  return guided_matches({content_a.features, refinement.at[a]}, {content_b.features, refinement.at[b]}, gate,
                        {config.most_bits, config.ratio}, within);
}

/// Follows the corners to the next place.
void follow_next(const CeilingConfig& config, CeilingRefinement& refinement) {
  const std::size_t here = refinement.at.size();
  const CeilingContent& content = *refinement.run[here].content;
  refinement.at.push_back(level_points(content.camera, content.attitude, content.features));
  std::vector<MatchedPlace> matched;
  Relation there_from_here = Metric2{};
  for (std::size_t back = 1; back <= std::min(here, kPlacesBack.back()); ++back) {
    const std::size_t there = here - back;
    there_from_here = compose(taught_step(refinement.run, there + 1), there_from_here);
    if (std::find(kPlacesBack.begin(), kPlacesBack.end(), back) == kPlacesBack.end()) continue;
    matched.push_back(
        {static_cast<std::uint32_t>(there), matches_by_odometry(config, refinement, there, here, there_from_here)});
  }
  refinement.corners.add(content.features.size(), matched);
}

/// Begins the adjustment; what cannot be adjusted is not refined.
void begin_adjustment(const CeilingConfig& config, CeilingRefinement& refinement) {
  RunMosaic run = mosaic_of(config, refinement.run, refinement.corners.corners());
  Result<MosaicAdjustment> adjustment =
      MosaicAdjustment::make(std::move(run.mosaic), bounds_for(refinement.run.size()));
  if (!adjustment) {
    refinement = {};
    return;
  }
  refinement.features = std::move(run.features);
  refinement.adjustment = std::move(*adjustment);
}

}  // namespace

CeilingRefinement Ceiling::begin_refine(const CeilingRun& run) const {
  CeilingRefinement refinement;
  if (is_adjustable(run)) refinement.run = run;
  return refinement;
}

bool Ceiling::refine(Refinement& refinement) const {
  const std::size_t places = refinement.run.size();
  if (places == 0) return false;
  if (refinement.adjustment) return refinement.adjustment->step();
  if (refinement.at.size() == places) {
    begin_adjustment(config_, refinement);
    return refinement.adjustment.has_value();
  }
  const std::size_t end = std::min(refinement.at.size() + kPlacesAPiece, places);
  while (refinement.at.size() < end) follow_next(config_, refinement);
  return true;
}

std::size_t Ceiling::pieces(const Refinement& refinement) const {
  const std::size_t places = refinement.run.size();
  if (places == 0) return 0;
  const std::size_t following = (places + kPlacesAPiece - 1) / kPlacesAPiece + 1;  // and one that begins to adjust
  if (refinement.adjustment) return following + refinement.adjustment->pieces();
  return following + MosaicAdjustment::most_pieces(places, features_in(refinement.run) / 2, bounds_for(places));
}

Amendments<CeilingContent> Ceiling::refined(Refinement refinement) const {
  if (!refinement.adjustment) return {};
  return amendments_of(config_, refinement.run, refinement.adjustment->mosaic(), refinement.features);
}

}  // namespace weft::agents
