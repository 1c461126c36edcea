#include "agents/perception/plane/repetition.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "core/geometry/pose2.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kLikes = 3;   // kept of each feature: on tiles many are alike
constexpr double kHardlyRad = 0.7;  // two features' own headings against each other

/// Keeps features in the order of their own headings, twice round: those headed alike lie side by side.
class ByHeading {
 public:
  explicit ByHeading(const std::vector<PlaneFeature>& features) {
    for (std::uint32_t i = 0; i < features.size(); ++i) turns_.push_back({wrap_angle(features[i].heading_rad), i});
    std::sort(turns_.begin(), turns_.end());
    const std::size_t once = turns_.size();
    for (std::size_t k = 0; k < once; ++k)
      turns_.emplace_back(turns_[k].first + 2.0 * std::numbers::pi, turns_[k].second);
    for (const auto& [heading, index] : turns_) indices_.push_back(index);
  }

  /// Returns the features headed within `within_rad`, less than half a turn, of this heading.
  std::span<const std::uint32_t> near(double heading_rad, double within_rad) const {
    double low = wrap_angle(heading_rad) - within_rad;
    if (low < -std::numbers::pi) low += 2.0 * std::numbers::pi;
    const auto at = [&](double heading) {
      return std::lower_bound(turns_.begin(), turns_.end(), heading,
                              [](const auto& turn, double wanted) { return turn.first < wanted; }) -
             turns_.begin();
    };
    const auto first = static_cast<std::size_t>(at(low));
    return std::span(indices_).subspan(first, static_cast<std::size_t>(at(low + 2.0 * within_rad)) - first);
  }
  std::span<const std::uint32_t> all() const { return std::span(indices_).first(indices_.size() / 2); }

 private:
  std::vector<std::pair<double, std::uint32_t>> turns_;
  std::vector<std::uint32_t> indices_;
};

/// Matches each feature of the stretch (b) with those most like it elsewhere (a), best first.
std::vector<Match> likes_elsewhere(const RepetitionBounds& bounds, const std::vector<PlaneFeature>& features,
                                   const std::vector<Eigen::Vector2d>& at, const std::vector<std::uint32_t>& stretch,
                                   double reach_m) {
  const std::vector<Descriptor> descriptors = descriptors_of(features);
  const ByHeading by_heading(features);
  std::vector<std::uint16_t> bits;
  std::vector<Match> likes;
  std::vector<Match> of_one;
  for (const std::uint32_t i : stretch) {
    of_one.clear();
    const std::span<const std::uint32_t> candidates =
        std::isfinite(reach_m) ? by_heading.near(features[i].heading_rad, kHardlyRad) : by_heading.all();
    hamming(descriptors[i], descriptors, candidates, bits);
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (bits[k] > bounds.most_bits) continue;  // first, as it leaves few
      const std::uint32_t j = candidates[k];
      const double apart_m = (at[i] - at[j]).norm();
      if (apart_m >= bounds.least_m && apart_m <= reach_m) of_one.push_back({j, i, bits[k]});
    }
    const std::size_t kept = std::min(kLikes, of_one.size());
    std::partial_sort(
        of_one.begin(), of_one.begin() + static_cast<std::ptrdiff_t>(kept), of_one.end(),
        [](const Match& x, const Match& y) { return std::pair(x.distance, x.a) < std::pair(y.distance, y.a); });
    likes.insert(likes.end(), of_one.begin(), of_one.begin() + static_cast<std::ptrdiff_t>(kept));
  }
  std::stable_sort(likes.begin(), likes.end(),
                   [](const Match& x, const Match& y) { return x.distance < y.distance; });
  return likes;
}

/// Returns those features of the stretch that have their like anywhere.
std::set<std::uint32_t> having_likes(const std::vector<Match>& likes) {
  std::set<std::uint32_t> some;
  for (const Match& like : likes) some.insert(like.b);
  return some;
}

}  // namespace

Repetition find_repetition(const RepetitionBounds& bounds, const std::vector<PlaneFeature>& features,
                           const std::vector<Eigen::Vector2d>& at, const std::vector<std::uint32_t>& stretch,
                           double reach_m, std::size_t fewest) {
  const std::vector<Match> likes = likes_elsewhere(bounds, features, at, stretch, reach_m);
  if (likes.size() < 2 || having_likes(likes).size() < fewest) return {};
  const Consensus consensus = find_consensus(bounds.consensus, likes, at, at);
  std::set<std::uint32_t> agreeing;
  for (const Match& like : likes)
    if ((consensus.a_from_b * at[like.b] - at[like.a]).norm() < bounds.consensus.within_m) agreeing.insert(like.b);
  std::vector<Eigen::Vector2d> all;
  std::vector<Eigen::Vector2d> some;
  for (const std::uint32_t i : stretch) {
    all.push_back(at[i]);
    if (agreeing.contains(i)) some.push_back(at[i]);
  }
  const double whole = area_of(all);
  return {consensus.a_from_b, agreeing.size(), whole > 0.0 ? area_of(some) / whole : 0.0};
}

double share_with_twins(const std::vector<PlaneFeature>& features, const std::vector<Eigen::Vector2d>& at,
                        int most_bits, double least_m) {
  const std::vector<Descriptor> descriptors = descriptors_of(features);
  std::vector<std::uint32_t> all(features.size());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::uint16_t> bits;
  const auto has_twin = [&](std::uint32_t i) {
    hamming(descriptors[i], descriptors, all, bits);
    return std::any_of(all.begin(), all.end(),
                       [&](std::uint32_t j) { return bits[j] <= most_bits && (at[i] - at[j]).norm() >= least_m; });
  };
  const auto twins = static_cast<double>(std::count_if(all.begin(), all.end(), has_twin));
  return twins / std::max(1.0, static_cast<double>(features.size()));
}

}  // namespace weft::agents
