#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "clients/chart/chart.hpp"
#include "clients/evaluate/bearing/model.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// Of one trial with one seed, what pictures show; metres.
struct Shown {
  std::vector<charts::Dot> taught;  ///< true ways, site frame
  std::vector<charts::Dot> first;   ///< loop
  std::vector<charts::Dot> last;
  std::vector<charts::Dot> error;  ///< of the first loop, along the way
  std::vector<charts::Dot> model;  ///< the same foretold
};
Shown shown_of(const Course& course, const Repeated& repeated, const std::vector<ErrorAt>& first_loop,
               const std::vector<ErrorAt>& model);

/// DIR/TRIAL.json, whole or not at all. unavailable, exhausted: names the file.
Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown);
/// None: there is no such file, or it is none of these.
std::optional<Shown> read_shown(const std::filesystem::path& folder, const std::string& trial);

}  // namespace weft::evaluate::bearing
