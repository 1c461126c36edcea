#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "clients/evaluate/floor/score.hpp"
#include "clients/evaluate/floor/trace.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// The runs of one kind of floor that pictures show; all of one seed.
struct Shown {
  std::string kind;
  Trace taught;
  Trace repeated;                    ///< under the first of the lights that were studied
  std::map<double, Trace> at_rates;  ///< led with so many images a second
  std::vector<Trace> two_taught;     ///< two experiences, stitched where they meet
  Trace two_repeated;                ///< one way over both
};

/// What belongs to all pictures.
struct Pictured {
  std::vector<Shown> kinds;
  double camera_height_m = 0.6;
  std::string about;     ///< a line below each title: what was driven,
  std::string of_first;  ///< and what of it most pictures show
};

/// PNGs in the folder, one for each of the paper's figures 6 to 10 and their parts; their names.
/// `rows`: for the distribution of blind distances over all seeds.
Result<std::vector<std::string>> draw_figures(const Pictured& pictured, const Rows& rows, Seeds seeds,
                                              const std::filesystem::path& folder);

}  // namespace weft::evaluate::floor
