#include "clients/cli/layout.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "core/network/search.hpp"

namespace weft::cli {
namespace {

constexpr int kSweeps = 300;
constexpr double kBetweenIslands = 3.0;  // metres

/// Returns the first place of each experience, that with the most places first.
std::vector<PlaceId> anchors(const Window& network) {
  std::map<ExperienceId, std::size_t> sizes;
  for (const auto& [id, place] : network.places) ++sizes[id.experience];
  std::vector<std::pair<std::size_t, PlaceId>> sorted;
  for (const auto& [id, place] : network.places) {
    const bool first = sorted.empty() || sorted.back().second.experience != id.experience;
    if (first) sorted.emplace_back(sizes[id.experience], id);
  }
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<PlaceId> firsts;
  for (const auto& [size, id] : sorted) firsts.push_back(id);
  return firsts;
}

/// Returns the island of `anchor`: the places that can be reached from it, with their poses in the anchor's frame.
std::map<PlaceId, Pose2> compose_from(const Window& network, const PlaceId& anchor) {
  std::map<PlaceId, Pose2> poses = {{anchor, Pose2{}}};
  std::deque<PlaceId> along = {anchor};
  std::deque<Edge> over;  // stitches, for when nothing is left along an experience
  while (!along.empty() || !over.empty()) {
    if (along.empty()) {
      const Edge stitch = over.front();
      over.pop_front();
      const PlaceId from = poses.contains(stitch.id.a) ? stitch.id.a : stitch.id.b;
      const PlaceId to = other_end(stitch, from);
      if (poses.emplace(to, poses.at(from) * planar(relation_from(stitch, from))).second) along.push_back(to);
      continue;
    }
    const PlaceId from = along.front();
    along.pop_front();
    network.for_each_edge(from, [&](const Edge& edge) {
      if (edge.origin == Origin::stitch) {
        over.push_back(edge);
        return;
      }
      const PlaceId to = other_end(edge, from);
      if (poses.emplace(to, poses.at(from) * planar(relation_from(edge, from))).second) along.push_back(to);
    });
  }
  return poses;
}

/// Spreads what does not close, by Gauss-Seidel: each place moves to the mean of where its neighbours see it.
void ease(const Window& network, const PlaceId& anchor, std::map<PlaceId, Pose2>& poses) {
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (auto& [id, pose] : poses) {
      if (id == anchor) continue;
      double x = 0.0;
      double y = 0.0;
      double sine = 0.0;
      double cosine = 0.0;
      double count = 0.0;
      network.for_each_edge(id, [&, place = id](const Edge& edge) {
        const PlaceId other = other_end(edge, place);
        const Pose2 seen = poses.at(other) * planar(relation_from(edge, other));
        x += seen.x;
        y += seen.y;
        sine += std::sin(seen.heading);
        cosine += std::cos(seen.heading);
        count += 1.0;
      });
      if (count > 0.0) pose = {x / count, y / count, std::atan2(sine, cosine)};
    }
  }
}

/// Returns the turn about the origin that lays the island's longer axis along the sheet.
Pose2 sheet_from(const std::map<PlaceId, Pose2>& poses) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const auto& [id, pose] : poses) {
    mean_x += pose.x / static_cast<double>(poses.size());
    mean_y += pose.y / static_cast<double>(poses.size());
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const auto& [id, pose] : poses) {
    xx += (pose.x - mean_x) * (pose.x - mean_x);
    xy += (pose.x - mean_x) * (pose.y - mean_y);
    yy += (pose.y - mean_y) * (pose.y - mean_y);
  }
  return {0.0, 0.0, -0.5 * std::atan2(2.0 * xy, xx - yy)};
}

}  // namespace

Layout lay_out(const Window& network) {
  Layout layout;
  double right = 0.0;
  for (const PlaceId& anchor : anchors(network)) {
    if (layout.drawing_from_place.contains(anchor)) continue;
    std::map<PlaceId, Pose2> island = compose_from(network, anchor);
    ease(network, anchor, island);
    const Pose2 turned = sheet_from(island);
    double least_x = 0.0;
    double least_y = 0.0;
    double most_x = 0.0;
    for (auto& [id, pose] : island) {
      pose = turned * pose;
      least_x = std::min(least_x, pose.x);
      least_y = std::min(least_y, pose.y);
      most_x = std::max(most_x, pose.x);
    }
    const Pose2 beside{right - least_x, -least_y, 0.0};
    for (const auto& [id, pose] : island) {
      layout.drawing_from_place.emplace(id, beside * pose);
      layout.island.emplace(id, layout.islands);
    }
    right += most_x - least_x + kBetweenIslands;
    ++layout.islands;
  }
  return layout;
}

}  // namespace weft::cli
