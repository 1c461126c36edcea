#pragma once
#include <optional>
#include <string>
#include <vector>

#include "clients/evaluate/surroundings.hpp"
#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"
#include "clients/evaluate/topometric/taught.hpp"

namespace weft::evaluate::topometric {

/// Returns the trials that are driven when nobody asks for one, in order; all that there are has `night` besides.
std::vector<std::string> usual_trials(const Extent& extent);
std::vector<std::string> all_trials();

/// Returns the seeds that a trial is driven with, of those that are asked: some take the first few only.
Seeds seeds_of(const std::string& trial, Seeds asked);

/// Drives the trials of one seed; what several of them are about is taught once.
class SeedTrials {
 public:
  SeedTrials(const Scenes& scenes, const Extent& extent, const Driven& driven)
      : scenes_(scenes), extent_(extent), driven_(driven) {}

  /// Drives and judges one of `all_trials`. None: stopped. Errors of body and method.
  Result<std::optional<Measured>> measure(const std::string& trial);

 private:
  Result<std::optional<Measured>> measure_alone(const std::string& trial) const;
  Result<std::optional<Measured>> measure_on_map(const std::string& trial) const;
  /// Teaches level11 unless that is done. Returns false when it was stopped.
  Result<bool> teach_once();

  const Scenes& scenes_;
  Extent extent_;
  Driven driven_;
  std::optional<Taught> level11_;
};

}  // namespace weft::evaluate::topometric
