#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "clients/evaluate/scene.hpp"
#include "clients/evaluate/topometric/ride.hpp"
#include "core/result.hpp"

namespace weft::evaluate::topometric {

/// Says how much is driven, and what with.
struct Extent {
  int width_px = 320;     ///< of the pair's images: 320 or 480
  bool is_quick = false;  ///< some 70 m in all
};

/// Holds the sites and lines of the study, and what says so in a folder of results.
struct Scenes {
  Scene level11;
  Scene hall;
  Scene aisles;                                 ///< with the line of its first robot
  std::vector<agents::SitePoint> other_aisles;  ///< of its second
  std::string sha256;
};

/// Reads level11, hall and aisles of a folder, with their lines; pairs are as wide as the extent says. not_found,
/// invalid: names the file.
Result<Scenes> read_scenes(const std::filesystem::path& folder, const Extent& extent);

/// Says what all drives of one seed have in common.
struct Driven {
  std::uint64_t seed = 1;
  std::filesystem::path scratch;  ///< a file for the truth; made and removed
  std::function<bool()> asked_to_stop;
};

/// Returns a rider in that site, on that day.
Rider rider_of(const agents::sim::Site& site, const std::string& robot, const Driven& driven, std::uint64_t day);

/// Returns so many blackouts of a second or two, spread over a stretch of a body's time by the seed: dark, covered,
/// the left lens alone, frozen, in turn.
std::vector<agents::sim::Blackout> blackouts(std::size_t count, double from_s, double to_s, std::uint64_t seed);

}  // namespace weft::evaluate::topometric
