#pragma once
#include <filesystem>
#include <string>

#include "clients/evaluate/ceiling/trials.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct CeilingOptions {
  Seeds seeds;
  std::filesystem::path scenes;     ///< folder of sites and lines
  std::filesystem::path recording;  ///< folder of a real recording; one that is not there leaves its rows unmeasured
  std::filesystem::path out;        ///< folder; made if it is not there
  ceiling::Extent extent;
  std::string trial = {};  ///< one of `driven_trials`, or `frames`, alone; empty: all
};

namespace ceiling {

/// Studies how well robots navigate by ceilings, by the acceptance table (docs/ceiling-study.md). Keeps what the
/// folder holds, trial by trial. Prints the table; writes ceiling.csv, ceiling.json and a picture. Errors: files by
/// name, a folder of another study, body and method.
Result<Ended> study_ceiling(const CeilingOptions& options, const Surroundings& around);

}  // namespace ceiling
}  // namespace weft::evaluate
