#include "agents/perception/heading_vote.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr double kChanceBits =
    128.0;  // descriptors that have nothing to do with each other differ in half their bits

/// Bounds how far apart the same point may lie in two images.
struct Within {
  double most_shift_px = 0.0;
  double rise_px = 0.0;
  double most_rise_px = 0.0;
};

/// Describes the question that is voted on, a shift or a rise, with a bin for each pixel from -most_px on.
struct Question {
  int coordinate = 0;  ///< 0: columns, 1: rows
  double most_px = 0.0;
  double spread_px = 1.0;  ///< of a vote
};

struct Ballot {
  Match match;
  double moved_px = 0.0;
  double weight = 0.0;
};

std::vector<Descriptor> descriptors_of(const std::vector<UprightFeature>& features) {
  std::vector<Descriptor> descriptors;
  for (const UprightFeature& feature : features) descriptors.push_back(feature.descriptor);
  return descriptors;
}

/// Lists, for each feature of b, the indices of the features of a that it may be.
using Candidates = std::vector<std::vector<std::uint32_t>>;

Candidates candidates_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                         const Within& within) {
  Candidates candidates(b.size());
  std::vector<std::uint32_t> found(a.size());
  for (std::size_t j = 0; j < b.size(); ++j) {
    const Eigen::Vector2f here = b[j].pixel;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < a.size(); ++i) {  // without a branch, which would be guessed wrong all the time
      const Eigen::Vector2f apart = here - a[i].pixel;
      found[count] = i;
      count += static_cast<std::size_t>(std::abs(apart.x()) <= within.most_shift_px) &
               static_cast<std::size_t>(std::abs(apart.y() - within.rise_px) <= within.most_rise_px);
    }
    candidates[j].assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return candidates;
}

std::vector<Ballot> ballots_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                               const Candidates& candidates, int coordinate) {
  std::vector<Ballot> ballots;
  for (const Match& match : match_descriptors(descriptors_of(a), descriptors_of(b),
                                              {.most_bits = static_cast<int>(kChanceBits), .ratio = 1.0}, candidates))
    ballots.push_back({match, static_cast<double>(b[match.b].pixel[coordinate] - a[match.a].pixel[coordinate]),
                       1.0 - match.distance / kChanceBits});
  return ballots;
}

using Histogram = std::vector<double>;

Histogram empty_histogram(const Question& about) {
  return Histogram(static_cast<std::size_t>(2.0 * about.most_px) + 1, 0.0);
}

double moved_by(std::size_t bin, const Question& about) {
  return static_cast<double>(bin) - about.most_px;
}

void add(Histogram& bins, double moved_px, double weight) {
  const std::size_t middle = bins.size() / 2;
  const double at = moved_px + static_cast<double>(middle);
  bins[static_cast<std::size_t>(std::clamp(std::round(at), 0.0, static_cast<double>(bins.size() - 1)))] += weight;
}

/// Returns the histogram with each vote spread out as a Gaussian of height 1, whose standard deviation is
/// `spread_px`.
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

/// Returns by how many standard deviations the votes for each bin exceed what chance brings there. Matches of what is
/// not the same fall on any pair that may be one, and of these most have moved little.
Histogram above_chance(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                       const Candidates& candidates, const std::vector<Ballot>& ballots, const Question& about) {
  Histogram votes = empty_histogram(about);
  Histogram chances = votes;
  double weights = 0.0;
  double weights2 = 0.0;
  for (const Ballot& ballot : ballots) {
    add(votes, ballot.moved_px, ballot.weight);
    weights += ballot.weight;
    weights2 += ballot.weight * ballot.weight;
  }
  double pairs = 0.0;
  for (std::size_t j = 0; j < b.size(); ++j) {
    pairs += static_cast<double>(candidates[j].size());
    for (const std::uint32_t i : candidates[j])
      add(chances, static_cast<double>(b[j].pixel[about.coordinate] - a[i].pixel[about.coordinate]), 1.0);
  }
  votes = spread_out(votes, about.spread_px);
  chances = spread_out(chances, about.spread_px);
  // A bell's square is a bell 1 / sqrt(2) as wide, so the sum's variance is that much less than of whole votes.
  const double variance_of_one = M_SQRT1_2 * weights2 / std::max(weights, 1e-9);
  for (std::size_t bin = 0; bin < votes.size(); ++bin) {
    const double expected = chances[bin] * weights / std::max(pairs, 1.0);
    votes[bin] = (votes[bin] - expected) / std::sqrt(variance_of_one * (expected + 1.0));
  }
  return votes;
}

/// Returns the height of the highest bin that is at least `apart` bins from `winner`; at least 0.
double next_peak(const std::vector<double>& bins, std::size_t winner, double apart) {
  double highest = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (std::abs(static_cast<double>(i) - static_cast<double>(winner)) >= apart) highest = std::max(highest, bins[i]);
  }
  return highest;
}

std::size_t highest(const Histogram& heights) {
  return static_cast<std::size_t>(std::max_element(heights.begin(), heights.end()) - heights.begin());
}

}  // namespace

double frequent_rise(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b, double width_px,
                     const HeadingVoteConfig& config) {
  if (std::min(a.size(), b.size()) < static_cast<std::size_t>(config.fewest_features)) return 0.0;
  const Question rise{1, std::floor(config.widest_rise * width_px), std::max(1.0, config.spread * width_px)};
  const Candidates candidates = candidates_of(a, b, {std::floor(config.most_shift * width_px), 0.0, rise.most_px});
  const std::vector<Ballot> ballots = ballots_of(a, b, candidates, rise.coordinate);
  const Histogram heights = above_chance(a, b, candidates, ballots, rise);
  const std::size_t top = highest(heights);
  const double px = moved_by(top, rise);
  return heights[top] >= config.above_chance && std::abs(px) > 0.5 * config.most_rise * width_px ? px : 0.0;
}

tl::expected<HeadingVote, Undecided> vote_heading(const std::vector<UprightFeature>& a,
                                                  const std::vector<UprightFeature>& b, double width_px,
                                                  const HeadingVoteConfig& config, double rise_px) {
  const std::size_t fewest = std::min(a.size(), b.size());
  if (fewest < static_cast<std::size_t>(config.fewest_features))
    return tl::unexpected(
        Undecided{"few_features", static_cast<double>(fewest), static_cast<double>(config.fewest_features)});
  const Question shift{0, std::floor(config.most_shift * width_px), std::max(1.0, config.spread * width_px)};
  const Candidates candidates = candidates_of(a, b, {shift.most_px, rise_px, config.most_rise * width_px});
  const std::vector<Ballot> ballots = ballots_of(a, b, candidates, shift.coordinate);
  const Histogram heights = above_chance(a, b, candidates, ballots, shift);
  const std::size_t top = highest(heights);
  if (!(heights[top] >= config.above_chance))
    return tl::unexpected(Undecided{"no_majority", heights[top], config.above_chance});
  HeadingVote vote{.shift_px = moved_by(top, shift), .matches = static_cast<std::uint32_t>(ballots.size())};
  const double within = 2.0 * shift.spread_px;
  for (const Ballot& ballot : ballots) {
    if (std::abs(ballot.moved_px - vote.shift_px) <= within) vote.agreeing.push_back(ballot.match);
  }
  vote.votes = static_cast<std::uint32_t>(vote.agreeing.size());
  vote.above_chance = heights[top];
  vote.runner_up = std::max(0.0, next_peak(heights, top, 2.0 * within)) / heights[top];
  return vote;
}

}  // namespace weft::agents
