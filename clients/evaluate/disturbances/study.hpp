#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct DisturbancesOptions {
  Seeds seeds;
  std::filesystem::path site;     ///< file
  std::filesystem::path along;    ///< file: the line, "x y" a row; empty: SITE without .toml, /r1.line
  std::filesystem::path out;      ///< folder; made if it is not there
  double metres = 12.0;           ///< of the line that are driven
  std::vector<std::string> only;  ///< rows, or disturbances with all their rows; empty: all
};

/// Measures what is not in the output folder yet, keeps each row as soon as it is there, and at the end prints the
/// table and writes disturbances.csv, .json and .png. not_found, invalid: site, line or `only`; conflict: the folder
/// holds another study; unavailable: it cannot be written.
Result<Ended> study_disturbances(const DisturbancesOptions& options, const Surroundings& around);

}  // namespace weft::evaluate
