#pragma once
#include <filesystem>
#include <string>

#include "clients/evaluate/surroundings.hpp"
#include "clients/evaluate/topometric/scenes.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct TopometricOptions {
  Seeds seeds;
  std::string trial;  ///< only that one; empty: all but `night`
  topometric::Extent extent;
  std::filesystem::path scenes;
  std::filesystem::path out;
  bool is_json = false;  ///< one line of JSON instead of the table
};

namespace topometric {

/// Measures the method `topometric` by its acceptance table (docs/topometric-study.md), row by row; rows that the
/// folder holds are kept. missed: something that is asked does not hold. Errors of sites, bodies, method and files.
Result<Ended> study_topometric(const TopometricOptions& options, const Surroundings& around);

}  // namespace topometric
}  // namespace weft::evaluate
