#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "clients/evaluate/ceiling/scenes.hpp"
#include "clients/evaluate/ceiling/score.hpp"
#include "clients/evaluate/ceiling/way.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Says how much is driven.
struct Extent {
  double metres = 20.0;         ///< of a straight line
  std::size_t put_downs = 200;  ///< of each kind, with each seed
  bool is_quick = false;        ///< robots are put down on the line that is taught anyhow, and nothing else is driven
};

/// Returns the trials that are driven in simulation, in order.
std::vector<std::string> driven_trials(const Extent& extent);

/// Drives the trials of one seed; what several of them are about is taught once.
class SeedTrials {
 public:
  SeedTrials(const Scenes& scenes, const Extent& extent, std::uint64_t seed, std::filesystem::path scratch,
             std::function<bool()> asked_to_stop);

  /// Drives and scores one of `driven_trials`. None: stopped. Errors of body and method.
  Result<std::optional<Measured>> measure(const std::string& trial);

 private:
  using Taught = std::optional<Way>;

  /// Teaches the way unless it is there. Returns false when it was stopped.
  Result<bool> teach_once(const Scene& scene, Taught& way) const;
  Result<std::optional<Measured>> found(const std::string& trial, const Way& way) const;

  const Scenes& scenes_;
  Extent extent_;
  Driven driven_;
  Taught line_;
  Taught loop_;
  Taught lamps_;
};

/// Watches a recording of a real ceiling: as `measure_frames` does, and for comparison with the camera taken to look
/// straight up (`untilted_`). None: stopped. Errors as of `read_recording` and `measure_frames`.
Result<std::optional<Measured>> measure_recording(const std::filesystem::path& folder,
                                                  const std::function<bool()>& asked_to_stop);

}  // namespace weft::evaluate::ceiling
