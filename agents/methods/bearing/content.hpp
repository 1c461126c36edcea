#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "agents/perception/motion.hpp"
#include "agents/perception/upright_features.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Counts of how often robots that came by have seen a feature of a place; the pass in which it came in counts.
struct Sightings {
  std::uint8_t could = 1;  ///< passes in which it would have lain within the image: at least `seen`
  std::uint8_t seen = 1;
  bool operator==(const Sightings&) const = default;
};

/// Holds what `bearing` stores of a place (docs/formats/bearing-content.md): what was seen ahead, and how the robot
/// was driving (the velocity profile of Krajnik et al. 2018, III-B).
struct BearingContent {
  std::vector<UprightFeature> features;  ///< pixels from the image's middle, at `focal_px`
  double focal_px = 386.0;
  Twist driving;
  std::vector<Sightings> sightings = {};  ///< of each feature; empty: as it was taught, nothing was learned yet
  Description description =
      Description::gradients;  ///< of all features: what is described otherwise is alike by chance
};

/// Returns the sightings of each feature, also of a place that was only taught.
std::vector<Sightings> sightings_of(const BearingContent& content);

inline constexpr std::uint32_t bearing_content_format = 1;  ///< as it was taught: all robots read it
inline constexpr std::uint32_t bearing_learned_format = 2;  ///< with sightings
inline constexpr std::uint32_t brief_after = 2;             ///< formats further on, features are described by `brief`
inline constexpr std::size_t most_bearing_features = 4096;

Bytes encode_bearing_content(const BearingContent& content);
/// Reads any of these formats. corrupt: short, trailing or impossible values, naming field and offset; newer: a later
/// format.
Result<BearingContent> decode_bearing_content(ByteView bytes);

}  // namespace weft::agents
