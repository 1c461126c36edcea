#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "clients/evaluate/floor/trace.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Holds the runs of one kind of floor that pictures show; all of one seed.
struct Shown {
  std::string kind;
  Trace taught;
  Trace repeated;                    ///< under the first of the lights that were studied
  std::map<double, Trace> at_rates;  ///< led with so many images a second
  std::vector<Trace> two_taught;     ///< two experiences, stitched where they meet
  Trace two_repeated;                ///< one way over both
};

/// Holds what belongs to all pictures.
struct Pictured {
  std::vector<Shown> kinds;
  std::vector<std::string> lights;
  Seeds seeds;  ///< of the distribution of blind distances; all else is of the first one
  double camera_height_m = 0.6;
  std::string about;     ///< a line below each title: what was driven,
  std::string of_first;  ///< and what of it most pictures show
};

/// Writes DIR/series/floor.json: what the runs come to, as pictures show it. Metres and radians in the site's frame,
/// true seconds. unavailable: names the file.
Result<void> write_pictured(const std::filesystem::path& folder, const Pictured& pictured);

}  // namespace weft::evaluate::floor
