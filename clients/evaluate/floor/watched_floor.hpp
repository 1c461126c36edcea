#pragma once
#include <cstddef>
#include <memory>
#include <utility>

#include "agents/methods/floor/floor.hpp"

namespace weft::evaluate::floor {

/// Holds what the odometry of the newest sample came to.
struct SeenStep {
  agents::Step step;
  std::size_t matches = 0;
};

/// Is the method `floor` with a note of each step: a Navigator shows what it believes, not its odometry. Inherited,
/// not wrapped: whatever else the method has or will have stays the navigator's to use.
class WatchedFloor : public agents::Floor {
 public:
  WatchedFloor(agents::Floor floor, std::shared_ptr<SeenStep> into)
      : agents::Floor(std::move(floor)), into_(std::move(into)) {}

  agents::Step observe(Odometry& odometry, const agents::View* view, const agents::Motion& motion) const {
    into_->step = agents::Floor::observe(odometry, view, motion);
    into_->matches = into_->step.seen ? odometry.inliers : 0;
    return into_->step;
  }

 private:
  std::shared_ptr<SeenStep> into_;
};

}  // namespace weft::evaluate::floor
