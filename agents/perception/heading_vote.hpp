#pragma once
#include <tl/expected.hpp>

#include <cstdint>
#include <string_view>
#include <vector>

#include "agents/perception/upright_features.hpp"

namespace weft::agents {

struct HeadingVoteConfig {
  // In widths of the image, so that they are angles for cameras of one field of view.
  double most_shift = 0.39;   ///< [0.01, 1] to either side
  double most_rise = 0.10;    ///< [0.001, 1] between the rows of what may be the same point
  double widest_rise = 0.25;  ///< [0.001, 1] that another camera's height and pitch may bring
  double spread = 0.024;      ///< [0.001, 0.2] standard deviation of a vote: near things shift more than far ones
  int fewest_features = 20;   ///< [1, 1000] of either view
  double above_chance = 3.0;  ///< [0, 20] standard deviations that votes must exceed what chance brings
};

/// Holds the most frequent horizontal shift of what two views both show (Krajnik et al. 2018, III-C).
struct HeadingVote {
  double shift_px = 0.0;    ///< of b's features against a's, right positive
  std::uint32_t votes = 0;  ///< matches within twice their spread of it
  std::uint32_t matches = 0;
  double above_chance = 0.0;         ///< standard deviations that its votes exceed what chance brings
  double runner_up = 0.0;            ///< the same of the next peak, over the winner's, [0, 1]
  std::vector<Match> agreeing = {};  ///< those that are its votes
};

/// Tells why nothing is said: few_features or no_majority; with the number and its bound.
struct Undecided {
  std::string_view reason;
  double measured = 0.0;
  double bound = 0.0;
};

/// Returns by how many rows b's features lie below a's most often, in pixels: another camera stands higher or looks
/// further down. 0: by less than half of `most_rise`, so that a vote does not need to know, or nothing is said above
/// chance.
double frequent_rise(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b, double width_px,
                     const HeadingVoteConfig& config);

/// Finds the most frequent shift: each pair of features that are each other's nearest votes for its own, the more the
/// more alike they are. `width_px`: of both images. `rise_px`: the rise around which rows may differ by `most_rise`.
tl::expected<HeadingVote, Undecided> vote_heading(const std::vector<UprightFeature>& a,
                                                  const std::vector<UprightFeature>& b, double width_px,
                                                  const HeadingVoteConfig& config, double rise_px = 0.0);

}  // namespace weft::agents
