#pragma once
#include <filesystem>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct FloorOptions {
  Seeds seeds;
  std::filesystem::path site;    ///< file
  std::filesystem::path along;   ///< file: the line, "x y" a row; empty: SITE without .toml, /r1.line
  std::filesystem::path floors;  ///< folder of photographs; empty: the simulation's own floors
  std::filesystem::path out;     ///< folder; made if it is not there
  std::string kind;              ///< one floor; empty: all
  std::string light;             ///< one light or wear; empty: all
  double metres = 26.0;          ///< of the line that are driven
};

namespace floor {

/// Measures what is not in the output folder yet, keeps each row as soon as it is there, and at the end prints the
/// tables and writes floor.csv and floor.json. not_found, invalid: site, line, floor or light; conflict: the folder
/// holds another study; unavailable: it cannot be written.
Result<Ended> study_floor(const FloorOptions& options, const Surroundings& around);

}  // namespace floor
}  // namespace weft::evaluate
