#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "clients/evaluate/bearing/model.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// Holds what pictures show of one trial with one seed; metres.
struct Shown {
  using Points = std::vector<std::array<double, 2>>;
  Points taught;  ///< true ways, site frame
  Points first;   ///< loop
  Points last;
  Points error;  ///< of the first loop, along the way
  Points model;  ///< the same foretold
};
Shown shown_of(const Course& course, const Repeated& repeated, const std::vector<ErrorAt>& first_loop,
               const std::vector<ErrorAt>& model);

/// Writes DIR/TRIAL.json, whole or not at all. unavailable, exhausted: names the file.
Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown);

}  // namespace weft::evaluate::bearing
