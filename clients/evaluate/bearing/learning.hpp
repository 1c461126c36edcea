#pragma once
#include <filesystem>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct LearningOptions {
  Seeds seeds;
  std::string days;              ///< some; empty: all
  std::string line;              ///< LINE.line in the site LINE.toml
  std::filesystem::path scenes;  ///< folder of sites and lines
  std::filesystem::path out;     ///< folder; made if it is not there
};

namespace bearing {

/// Measures what learning of places is worth: a way is taught and driven once a day (days.hpp), by a robot from which
/// the places learn at the end of each day, and by one that learns nothing. Prints a table, writes
/// learning.csv. not_found, invalid: scene or days; refused: the way's end is not found to come back; unavailable: it
/// cannot be written.
Result<Ended> study_learning(const LearningOptions& options, const Surroundings& around);

}  // namespace bearing
}  // namespace weft::evaluate
