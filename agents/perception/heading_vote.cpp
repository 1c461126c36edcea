#include "agents/perception/heading_vote.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr double kChanceBits =
    128.0;  // descriptors that have nothing to do with each other differ in half their bits

struct InPixels {
  InPixels(const HeadingVoteConfig& config, double width_px)
      : most_shift(std::floor(config.most_shift * width_px)),
        most_rise(config.most_rise * width_px),
        spread(std::max(1.0, config.spread * width_px)) {}
  double most_shift, most_rise, spread;
};

struct Ballot {
  Match match;
  double shift_px = 0.0;
  double weight = 0.0;
};

std::vector<Descriptor> descriptors_of(const std::vector<UprightFeature>& features) {
  std::vector<Descriptor> descriptors;
  for (const UprightFeature& feature : features) descriptors.push_back(feature.descriptor);
  return descriptors;
}

/// Which of a each of b may be.
using Candidates = std::vector<std::vector<std::uint32_t>>;

Candidates candidates_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                         const InPixels& px) {
  Candidates candidates(b.size());
  std::vector<std::uint32_t> found(a.size());
  for (std::size_t j = 0; j < b.size(); ++j) {
    const Eigen::Vector2f here = b[j].pixel;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < a.size(); ++i) {  // without a branch, which would be guessed wrong all the time
      const Eigen::Vector2f apart = here - a[i].pixel;
      found[count] = i;
      count += static_cast<std::size_t>(std::abs(apart.x()) <= px.most_shift) &
               static_cast<std::size_t>(std::abs(apart.y()) <= px.most_rise);
    }
    candidates[j].assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return candidates;
}

std::vector<Ballot> ballots_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                               const Candidates& candidates) {
  std::vector<Ballot> ballots;
  for (const Match& match : match_descriptors(descriptors_of(a), descriptors_of(b),
                                              {.most_bits = static_cast<int>(kChanceBits), .ratio = 1.0}, candidates))
    ballots.push_back({match, static_cast<double>(b[match.b].pixel.x() - a[match.a].pixel.x()),
                       1.0 - match.distance / kChanceBits});
  return ballots;
}

/// A pixel a bin, from -most_shift on.
using Histogram = std::vector<double>;

Histogram empty_histogram(const InPixels& px) {
  return Histogram(static_cast<std::size_t>(2.0 * px.most_shift) + 1, 0.0);
}

double shift_of(std::size_t bin, const InPixels& px) {
  return static_cast<double>(bin) - px.most_shift;
}

void add(Histogram& bins, double shift_px, double weight) {
  const std::size_t middle = bins.size() / 2;
  const double at = shift_px + static_cast<double>(middle);
  bins[static_cast<std::size_t>(std::clamp(std::round(at), 0.0, static_cast<double>(bins.size() - 1)))] += weight;
}

/// Each vote as a bell.
Histogram spread_out(const Histogram& votes, double spread_px) {
  const auto reach = static_cast<std::ptrdiff_t>(3.0 * spread_px);
  std::vector<double> bell;
  for (std::ptrdiff_t off = -reach; off <= reach; ++off) {
    const double sigmas = static_cast<double>(off) / spread_px;
    bell.push_back(std::exp(-0.5 * sigmas * sigmas));
  }
  Histogram out(votes.size(), 0.0);
  const auto size = static_cast<std::ptrdiff_t>(votes.size());
  for (std::ptrdiff_t from = 0; from < size; ++from) {
    const double height = votes[static_cast<std::size_t>(from)];
    if (height == 0.0) continue;
    const std::ptrdiff_t last = std::min(size - 1, from + reach);
    for (std::ptrdiff_t to = std::max<std::ptrdiff_t>(0, from - reach); to <= last; ++to)
      out[static_cast<std::size_t>(to)] += height * bell[static_cast<std::size_t>(to - from + reach)];
  }
  return out;
}

/// How many standard deviations the votes for each shift exceed what chance brings there. Matches of what is not the
/// same fall on any pair that may be one, and of these most have small shifts.
Histogram above_chance(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                       const Candidates& candidates, const std::vector<Ballot>& ballots, const InPixels& px) {
  Histogram votes = empty_histogram(px);
  Histogram chances = votes;
  double weights = 0.0;
  double weights2 = 0.0;
  for (const Ballot& ballot : ballots) {
    add(votes, ballot.shift_px, ballot.weight);
    weights += ballot.weight;
    weights2 += ballot.weight * ballot.weight;
  }
  double pairs = 0.0;
  for (std::size_t j = 0; j < b.size(); ++j) {
    pairs += static_cast<double>(candidates[j].size());
    for (const std::uint32_t i : candidates[j])
      add(chances, static_cast<double>(b[j].pixel.x() - a[i].pixel.x()), 1.0);
  }
  votes = spread_out(votes, px.spread);
  chances = spread_out(chances, px.spread);
  // A bell's square is a bell 1 / sqrt(2) as wide, so the sum's variance is that much less than of whole votes.
  const double variance_of_one = M_SQRT1_2 * weights2 / std::max(weights, 1e-9);
  for (std::size_t bin = 0; bin < votes.size(); ++bin) {
    const double expected = chances[bin] * weights / std::max(pairs, 1.0);
    votes[bin] = (votes[bin] - expected) / std::sqrt(variance_of_one * (expected + 1.0));
  }
  return votes;
}

/// Highest bin that is at least `apart` bins from `winner`.
double next_peak(const std::vector<double>& bins, std::size_t winner, double apart) {
  double highest = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (std::abs(static_cast<double>(i) - static_cast<double>(winner)) >= apart) highest = std::max(highest, bins[i]);
  }
  return highest;
}

}  // namespace

tl::expected<HeadingVote, Undecided> vote_heading(const std::vector<UprightFeature>& a,
                                                  const std::vector<UprightFeature>& b, double width_px,
                                                  const HeadingVoteConfig& config) {
  const std::size_t fewest = std::min(a.size(), b.size());
  if (fewest < static_cast<std::size_t>(config.fewest_features))
    return tl::unexpected(
        Undecided{"few_features", static_cast<double>(fewest), static_cast<double>(config.fewest_features)});
  const InPixels px(config, width_px);
  const Candidates candidates = candidates_of(a, b, px);
  const std::vector<Ballot> ballots = ballots_of(a, b, candidates);
  const Histogram heights = above_chance(a, b, candidates, ballots, px);
  const auto top = static_cast<std::size_t>(std::max_element(heights.begin(), heights.end()) - heights.begin());
  if (!(heights[top] >= config.above_chance))
    return tl::unexpected(Undecided{"no_majority", heights[top], config.above_chance});
  HeadingVote vote{.shift_px = shift_of(top, px), .matches = static_cast<std::uint32_t>(ballots.size())};
  const double within = 2.0 * px.spread;
  for (const Ballot& ballot : ballots) {
    if (std::abs(ballot.shift_px - vote.shift_px) <= within) vote.agreeing.push_back(ballot.match);
  }
  vote.votes = static_cast<std::uint32_t>(vote.agreeing.size());
  vote.above_chance = heights[top];
  vote.runner_up = std::max(0.0, next_peak(heights, top, 2.0 * within)) / heights[top];
  return vote;
}

}  // namespace weft::agents
