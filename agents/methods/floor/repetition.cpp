#include "agents/methods/floor/repetition.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "agents/methods/floor/consensus.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kLikes = 3;   // kept of each feature: on tiles many are alike
constexpr double kHardlyRad = 0.7;  // two features' own headings against each other

/// Each feature of the stretch with those most like it elsewhere, best first.
std::vector<Match> likes_elsewhere(const FloorConfig& c, const std::vector<FloorFeature>& features,
                                   const std::vector<Eigen::Vector2d>& at, const std::vector<std::uint32_t>& stretch,
                                   double reach_m) {
  const std::vector<Descriptor> descriptors = descriptors_of(features);
  std::vector<std::uint32_t> all(features.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::uint16_t> bits;
  std::vector<Match> likes;
  std::vector<Match> of_one;
  for (const std::uint32_t i : stretch) {
    of_one.clear();
    hamming(descriptors[i], descriptors, all, bits);
    for (std::uint32_t j = 0; j < features.size(); ++j) {
      if (bits[j] > c.most_bits) continue;  // first, as it leaves few
      const double apart_m = (at[i] - at[j]).norm();
      if (apart_m < kNoRepetitionM || apart_m > reach_m) continue;
      if (std::isfinite(reach_m) &&
          std::abs(wrap_angle(features[i].heading_rad - features[j].heading_rad)) > kHardlyRad)
        continue;
      of_one.push_back({j, i, bits[j]});
    }
    const std::size_t kept = std::min(kLikes, of_one.size());
    std::partial_sort(of_one.begin(), of_one.begin() + static_cast<std::ptrdiff_t>(kept), of_one.end(),
                      [](const Match& x, const Match& y) { return x.distance < y.distance; });
    likes.insert(likes.end(), of_one.begin(), of_one.begin() + static_cast<std::ptrdiff_t>(kept));
  }
  std::stable_sort(likes.begin(), likes.end(),
                   [](const Match& x, const Match& y) { return x.distance < y.distance; });
  return likes;
}

}  // namespace

Repetition find_repetition(const FloorConfig& c, const std::vector<FloorFeature>& features,
                           const std::vector<Eigen::Vector2d>& at, const std::vector<std::uint32_t>& stretch,
                           double reach_m) {
  const std::vector<Match> likes = likes_elsewhere(c, features, at, stretch, reach_m);
  if (likes.size() < 2) return {};
  const Consensus consensus = find_consensus(c, likes, at, at);
  std::set<std::uint32_t> agreeing;
  for (const Match& like : likes)
    if ((consensus.a_from_b * at[like.b] - at[like.a]).norm() < c.consensus_m) agreeing.insert(like.b);
  std::vector<Eigen::Vector2d> all;
  std::vector<Eigen::Vector2d> some;
  for (const std::uint32_t i : stretch) {
    all.push_back(at[i]);
    if (agreeing.contains(i)) some.push_back(at[i]);
  }
  const double whole = area_of(all);
  return {consensus.a_from_b, agreeing.size(), whole > 0.0 ? area_of(some) / whole : 0.0};
}

}  // namespace weft::agents
