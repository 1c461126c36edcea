#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "clients/evaluate/floor/rows.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Holds what every study of floors is asked for.
struct FloorOptions {
  Seeds seeds;
  std::filesystem::path site;             ///< file
  std::filesystem::path along;            ///< file: the line, "x y" a row; empty: SITE without .toml, /r1.line
  std::filesystem::path floors;           ///< folder of photographs; empty: the simulation's own floors
  std::filesystem::path out;              ///< folder; made if it is not there
  std::string kind;                       ///< one floor; empty: all
  std::string light;                      ///< one light or wear; empty: `usual_lights`
  std::vector<std::string> usual_lights;  ///< empty: all
  double metres = 26.0;                   ///< of the line that are driven
};

namespace floor {

/// Says on which floors and under which lights what is driven, and what says so in a folder of results.
struct Subject {
  Stage stage;
  Study study;
  std::vector<std::string> kinds;
  std::vector<std::string> lights;
};

/// Reads all but the line, which is still to be drawn. not_found, invalid: site, floor or light, named.
Result<Subject> subject_without_line(const FloorOptions& options, std::function<bool()> asked_to_stop);
/// Reads site and line. not_found, invalid: site, line, floor or light, named.
Result<Subject> subject_of(const FloorOptions& options, std::function<bool()> asked_to_stop);

}  // namespace floor
}  // namespace weft::evaluate
