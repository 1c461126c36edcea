#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "server/eta/arrivals.hpp"
#include "tests/bench/traffic/leased.hpp"

namespace weft::bench {

/// Compares when robots come to their goals with what was foretold half of the way there, by what the product learns
/// of their reports.
class Foretold {
 public:
  explicit Foretold(Fleet& fleet) : fleet_(fleet), robots_(fleet.robots().size()) {}

  /// Takes the robots' reports of where they are; so many seconds have passed since the beginning.
  void hear(Leased& leased, double now_s);
  /// Foretells for those that are half way, and notes which robots have arrived. To be called once a step.
  void look(Leased& leased, double now_s);

  const std::vector<Foreseen>& foreseen() const { return foreseen_; }

 private:
  struct Open {
    double at_s = 0.0;
    double left_s = 0.0;
    double soonest_s = 0.0;
    double latest_s = 0.0;
  };
  struct Followed {
    server::Passing passing;
    int asked_at = -1;
    std::uint32_t steps = 0;  ///< to its goal, when it was asked
    std::optional<Open> open;
  };

  Route way_left(const Leased::Way& way, std::size_t robot, const TaughtLanes& lanes);

  Fleet& fleet_;
  server::Speeds speeds_;
  server::Band band_;
  std::vector<Followed> robots_;
  std::vector<Foreseen> foreseen_;
};

}  // namespace weft::bench
