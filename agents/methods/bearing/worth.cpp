// Whether a place has learned so much that all robots are to have it.
#include <algorithm>

#include "agents/methods/bearing/bearing.hpp"

namespace weft::agents {
namespace {

/// Predicts how many features a robot that comes by will see, by the passes since `shared` was.
class Outlook {
 public:
  explicit Outlook(double stays) : stays_(stays) {}

  /// Adds a feature of `shared` that stayed in `learned`.
  void add_old(const Sightings& then, const Sightings& now) {
    const bool is_halved = now.could < then.could || now.seen < then.seen;
    const double seen =
        chance(is_halved ? now.seen : now.seen - then.seen, is_halved ? now.could : now.could - then.could);
    shared += seen;
    learned += seen;
  }
  void add_gone() { shared += chance(0, 1); }
  void add_new(const Sightings& now) { learned += chance(std::max(0, now.seen - 1), now.could - 1); }

  double shared = 0.0;
  double learned = 0.0;

 private:
  double chance(int seen, int could) const {
    constexpr double prior_passes = 0.25;
    return (seen + prior_passes * stays_) / (could + prior_passes);
  }
  double stays_;
};

bool is_same(const UprightFeature& a, const UprightFeature& b) {
  return a.pixel == b.pixel && a.descriptor == b.descriptor;
}

}  // namespace

bool Bearing::is_worth_sharing(const Content& shared, const Content& learned) const {
  const std::vector<Sightings> then = sightings_of(shared);
  const std::vector<Sightings> now = sightings_of(learned);
  Outlook outlook(config_.learn.stays);
  std::size_t next = 0;  // of shared: learning keeps the order
  for (std::size_t i = 0; i < learned.features.size(); ++i) {
    std::size_t same = next;
    while (same < shared.features.size() && !is_same(shared.features[same], learned.features[i])) ++same;
    if (same == shared.features.size()) {
      outlook.add_new(now[i]);
      continue;
    }
    for (; next < same; ++next) outlook.add_gone();
    outlook.add_old(then[same], now[i]);
    next = same + 1;
  }
  for (; next < shared.features.size(); ++next) outlook.add_gone();
  return outlook.learned > (1.0 + config_.learn.worth) * outlook.shared;
}

}  // namespace weft::agents
