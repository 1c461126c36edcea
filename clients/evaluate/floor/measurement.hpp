#pragma once
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/floor/figure_runs.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/floor/score.hpp"
#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Measures the rows of one floor and one seed: taught once, then repeated under each light. Hands each on as soon as
/// it is there.
class Measurement {
 public:
  using Keep = std::function<Result<void>(const RowKey&, const Score&)>;

  /// Measures a scenario. With `all_runs` every run is put on the shelf.
  Measurement(const Scenario& scenario, Shelf shelf, bool all_runs, const Surroundings& around, Keep keep)
      : scenario_(scenario), shelf_(std::move(shelf)), all_runs_(all_runs), around_(around), keep_(std::move(keep)) {}

  /// Drives and scores; below, a repeat under a light. Errors of the drives, of the shelf and of `keep`.
  Result<Ended> mapping();
  Result<Ended> repeat_under(const std::string& light);

 private:
  Result<Ended> calibrate_once();
  Result<Ended> teach_once();
  Result<void> shelve(const std::string& what, const Trace& trace) const;
  Result<Ended> keep(const std::string& part, Score score, double began_s);

  const Scenario& scenario_;
  Shelf shelf_;
  bool all_runs_;
  const Surroundings& around_;
  Keep keep_;
  std::optional<agents::CameraModel> camera_;
  Taught taught_;
};

}  // namespace weft::evaluate::floor
