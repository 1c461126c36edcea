#include "agents/adjustment/mosaic_adjustment.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "agents/adjustment/placed_point.hpp"
#include "agents/adjustment/pose_graph.hpp"

namespace weft::agents {
namespace {

constexpr double kShareOfWindow = 0.5;  // each place is in two of them

/// Returns how many windows cover all places, the last one whole and reaching to the end.
std::size_t windows_over(std::size_t places, std::size_t window) {
  const std::size_t half = window / 2;
  return places <= window ? 1 : 1 + (places - window + half - 1) / half;
}

tl::unexpected<Error> invalid(const std::string& what) {
  return fail(ErrorCode::invalid, "mosaic: " + what);
}

/// Returns the first place that no link joins to the next one; none: there is none.
std::optional<std::size_t> loose_end(const Mosaic& mosaic) {
  std::vector<bool> is_joined(mosaic.places.size(), false);
  for (const MosaicLink& link : mosaic.links) {
    if (!link.is_stitch && link.from + 1 == link.to) is_joined[link.from] = true;
  }
  for (std::size_t i = 0; i + 1 < is_joined.size(); ++i)
    if (!is_joined[i]) return i;
  return std::nullopt;
}

}  // namespace

Result<MosaicAdjustment> MosaicAdjustment::make(Mosaic mosaic, const MosaicAdjustmentConfig& config) {
  if (config.window_places < 4 || config.window_places % 2 != 0)
    return invalid("windows of " + std::to_string(config.window_places) + " places; at least 4, and an even number");
  if (config.graph_iterations < 1 || config.graph_pieces < 1 || config.points_each < 1)
    return invalid("iterations, pieces and points of a piece are at least 1 each");
  if (const std::string problem = problem_of(mosaic); !problem.empty()) return invalid(problem);
  if (mosaic.places.size() < 2) return invalid("fewer than 2 places");
  if (const auto end = loose_end(mosaic))
    return invalid("no link joins place " + std::to_string(*end) + " to the next one");
  return MosaicAdjustment(std::move(mosaic), config);
}

MosaicAdjustment::MosaicAdjustment(Mosaic mosaic, const MosaicAdjustmentConfig& config)
    : config_(config), mosaic_(std::move(mosaic)), index_(mosaic_) {
  std::ranges::copy_if(mosaic_.links, std::back_inserter(stitches_), &MosaicLink::is_stitch);
}

std::uint32_t MosaicAdjustment::window_begin(std::size_t window) const {
  const auto places = static_cast<std::uint32_t>(mosaic_.places.size());
  const std::uint32_t size = std::min(config_.window_places, places);
  return std::min(static_cast<std::uint32_t>(window) * (config_.window_places / 2), places - size);
}

std::size_t MosaicAdjustment::most_pieces(std::size_t places, std::size_t points,
                                          const MosaicAdjustmentConfig& config) {
  return windows_over(places, config.window_places) + config.graph_pieces +
         (points + config.points_each - 1) / config.points_each;
}

bool MosaicAdjustment::step() {
  const bool has_windows = windows_.size() < windows_over(mosaic_.places.size(), config_.window_places);
  if (has_windows) {
    fit_next_window();
  } else if (!is_graph_done_) {
    adjust_all_poses();
  } else if (points_ < mosaic_.points.size()) {
    place_points();
  } else {
    return false;
  }
  ++done_;
  return has_windows || !is_graph_done_ || points_ < mosaic_.points.size();
}

void MosaicAdjustment::fit_next_window() {
  const auto count =
      std::min<std::uint32_t>(config_.window_places, static_cast<std::uint32_t>(mosaic_.places.size()));
  windows_.push_back(fit_window(mosaic_, index_, window_begin(windows_.size()), count));
}

void MosaicAdjustment::adjust_all_poses() {
  std::vector<Pose2> poses;
  for (const MosaicPlace& place : mosaic_.places) poses.push_back(place.map_from_place);
  is_graph_done_ = adjust_poses(poses, windows_, stitches_, windows_.size() > 1 ? kShareOfWindow : 1.0,
                                static_cast<int>(config_.graph_iterations));
  if (++graph_pieces_ == config_.graph_pieces) is_graph_done_ = true;
  for (std::size_t i = 0; i < poses.size(); ++i) mosaic_.places[i].map_from_place = poses[i];
  if (!is_graph_done_) return;
  // A later window counts from its first quarter on, where it has places nearer to its middle than the one before.
  for (const WindowFit& window : windows_) {
    const std::size_t from = window.first == 0 ? 0 : window.attitudes.size() / 4;
    for (std::size_t i = from; i < window.attitudes.size(); ++i)
      mosaic_.places[window.first + i].attitude = window.attitudes[i];
  }
}

void MosaicAdjustment::place_points() {
  const auto all = static_cast<std::uint32_t>(mosaic_.points.size());
  const std::uint32_t end = std::min(points_ + config_.points_each, all);
  for (; points_ < end; ++points_) mosaic_.points[points_] = placed(mosaic_, index_, points_);
}

}  // namespace weft::agents
