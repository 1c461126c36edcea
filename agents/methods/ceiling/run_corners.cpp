#include "agents/methods/ceiling/run_corners.hpp"

#include <limits>
#include <utility>

namespace weft::agents {

void RunCorners::add(std::size_t features, std::span<const MatchedPlace> matched) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  const auto place = static_cast<std::uint32_t>(corner_of_.size());
  std::vector<std::uint32_t> corner_of(features, none);
  for (const MatchedPlace& earlier : matched) {
    for (const Match& match : earlier.matches) {
      const std::uint32_t corner = corner_of_[earlier.place][match.a];
      if (corner_of[match.b] != none || corners_[corner].back().place == place) continue;
      corner_of[match.b] = corner;
      corners_[corner].push_back({place, match.b});
    }
  }
  for (std::uint32_t i = 0; i < features; ++i) {
    if (corner_of[i] != none) continue;
    corner_of[i] = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back({{place, i}});
  }
  corner_of_.push_back(std::move(corner_of));
}

}  // namespace weft::agents
