#pragma once
#include <vector>

#include "agents/perception/motion.hpp"
#include "agents/perception/upright_features.hpp"
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// What `bearing` stores of a place (docs/formats/bearing-content.md): what was seen ahead, and how the robot was
/// driving (the velocity profile of Krajnik et al. 2018, III-B).
struct BearingContent {
  std::vector<UprightFeature> features;  ///< pixels from the image's middle, at `focal_px`
  double focal_px = 386.0;
  Twist driving;
};

inline constexpr std::uint32_t bearing_content_format = 1;
inline constexpr std::size_t most_bearing_features = 4096;

Bytes encode_bearing_content(const BearingContent& content);
/// corrupt: short, trailing or impossible values, naming field and offset; newer: a later format.
Result<BearingContent> decode_bearing_content(ByteView bytes);

}  // namespace weft::agents
