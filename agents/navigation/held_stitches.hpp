#pragma once
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
  explicit HeldStitches(const StitchConfig& config) : config_(config) {}

  /// Takes the stitches of a place that was kept `driven_m` into the run.
  void take(const std::vector<Edge>& stitches, double driven_m);
  /// Takes what speaks against this run lying where it seems to lie beside the other one (Contradicts).
  void contradict(const ExperienceId& other, double by);
  /// Gives up what is held if too much speaks against it, and returns how much: "looks_like_another". The run is not
  /// stitched to those others any more.
  std::optional<Refusal> disproved();
  /// Returns those that are proven by now, each once.
  std::vector<Edge> proven(double driven_m);
  /// Returns all that are held, as the run ends.
  std::vector<Edge> rest();

  /// Returns the latest of the other runs' places that this one is held to lie beside; none: nothing is held.
  std::optional<PlaceId> beside() const;
  /// Returns whether this run has been told apart from the other one.
  bool is_elsewhere(const ExperienceId& other) const { return elsewhere_.contains(other); }
  const std::set<ExperienceId>& elsewhere() const { return elsewhere_; }

 private:
  StitchConfig config_;
  std::vector<Edge> held_;
  std::set<ExperienceId> doubted_;    ///< runs that something speaks against since `contradiction_` was 0
  std::set<ExperienceId> elsewhere_;  ///< runs that this one is not stitched to any more
  double contradiction_ = 0.0;
  double beside_m_ = 0.0;    ///< driven from stitch to stitch since it came upon other runs
  double stitched_m_ = 0.0;  ///< how far into the run the latest stitch was found
  bool is_proven_ = false;
};

}  // namespace weft::agents
