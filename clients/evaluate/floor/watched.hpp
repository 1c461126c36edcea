#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "agents/methods/method.hpp"

namespace weft::evaluate::floor {

/// Holds what the odometry of the newest sample came to.
struct SeenStep {
  agents::Step step;
  std::size_t matches = 0;
};

/// Is a method with a note of each step: a Navigator shows what it believes, not its odometry. Inherited, not
/// wrapped: whatever else the method has or will have stays the navigator's to use.
template <agents::Method M>
class Watched : public M {
 public:
  /// Is told each sample with what odometry has made of it; view null: a dropped frame.
  using Look = std::function<void(const typename M::Odometry&, const agents::View*, const agents::Motion&)>;

  /// Notes into `into`; `look`: empty, where no more is wanted than that.
  Watched(M method, std::shared_ptr<SeenStep> into, Look look = {})
      : M(std::move(method)), into_(std::move(into)), look_(std::move(look)) {}

  agents::Step observe(typename M::Odometry& odometry, const agents::View* view, const agents::Motion& motion) const {
    into_->step = M::observe(odometry, view, motion);
    into_->matches = into_->step.seen ? odometry.inliers : 0;
    if (look_) look_(odometry, view, motion);
    return into_->step;
  }

 private:
  std::shared_ptr<SeenStep> into_;
  Look look_;
};

}  // namespace weft::evaluate::floor
