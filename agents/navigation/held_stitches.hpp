#pragma once
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/network/network.hpp"

namespace weft::agents {

/// Holds back what stitches a run to others until it is proven. Aisles that look alike are told apart by what lies
/// around their ends: a run through one of them would be joined to the other all along before anything speaks against
/// that. A value.
class HeldStitches {
 public:
  /// Shows what was found at a place just kept.
  struct AtPlace {
    bool is_beside = false;                         ///< places of other runs are believed to be within reach
    std::vector<Edge> stitches;                     ///< to other runs
    std::map<ExperienceId, double> contradictions;  ///< what speaks against each of them lying there (Contradicts)
  };

  explicit HeldStitches(const StitchConfig& config) : config_(config) {}

  /// Takes what was found `driven_m` into the run.
  void take(const AtPlace& found, double driven_m);
  /// Gives up all that is held if too much speaks against one of the other runs, and returns how much: "told_apart".
  /// The run is not stitched to those others any more.
  std::optional<Refusal> disproved();
  /// Returns those that are proven by now, each once.
  std::vector<Edge> proven(double driven_m);
  /// Returns all that are held, as the run ends.
  std::vector<Edge> rest();

  /// Returns the latest of the other runs' places that this one is held to lie beside; none: nothing is held.
  std::optional<PlaceId> beside() const;
  /// Returns the runs that this one has been told apart from.
  const std::set<ExperienceId>& elsewhere() const { return elsewhere_; }

 private:
  void part();

  StitchConfig config_;
  std::vector<Edge> held_;
  std::map<ExperienceId, double> contradictions_;  ///< since it came upon other runs
  std::set<ExperienceId> joined_;                  ///< runs to which stitches were handed in
  std::set<ExperienceId> elsewhere_;
  double beside_m_ = 0.0;    ///< driven from stitch to stitch since it came upon other runs
  double stitched_m_ = 0.0;  ///< how far into the run the latest stitch was found,
  double near_m_ = 0.0;      ///< and that others were last within reach
  bool is_proven_ = false;   ///< that it lies beside others, until it parts from them
};

}  // namespace weft::agents
