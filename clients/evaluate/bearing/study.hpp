#pragma once
#include <filesystem>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct BearingOptions {
  Seeds seeds;
  std::string trial;             ///< one; empty: all
  std::filesystem::path scenes;  ///< folder of sites and lines
  std::filesystem::path out;     ///< folder; made if it is not there
};

namespace bearing {

/// Measures what is not in the output folder yet, keeps each row as soon as it is there, and at the end prints the
/// tables, writes bearing.csv and bearing.json and draws the pictures. not_found, invalid: scene or trial; conflict:
/// the folder holds another study; unavailable: it cannot be written.
Result<Ended> study_bearing(const BearingOptions& options, const Surroundings& around);

}  // namespace bearing
}  // namespace weft::evaluate
