#pragma once
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "agents/methods/method.hpp"

namespace weft::agents {

/// Says how a robot of which nobody knows where it is turns. Those of methods that do not recover stand.
template <class M>
class Recovery {
 public:
  explicit Recovery(const M&) {}
  void advance(const Step&, Duration, bool) {}
  void asked() {}
  void stopped() {}
  std::optional<Twist> turn(typename M::Odometry&, bool) const { return std::nullopt; }
};

/// Lets the method look around while the robot does not know where it is: on the spot, and only for somebody who
/// waits for it, with a route or having asked where it is.
template <Recovers M>
class Recovery<M> {
 public:
  explicit Recovery(const M& method) : method_(&method) {}

  /// Takes the motion of a sample, and whether the robot does not know where it is.
  void advance(const Step& step, Duration elapsed, bool is_lost) {
    lost_ = is_lost ? lost_.value_or(LostFor{}) : std::optional<LostFor>{};
    if (!lost_) {
      is_asked_ = false;
      return;
    }
    lost_->time += elapsed;
    lost_->turned_rad += std::abs(heading_rad(step.previous_from_current));
  }
  /// Takes note that somebody wants to know where the robot is, until it is found or stopped.
  void asked() { is_asked_ = true; }
  void stopped() { is_asked_ = false; }

  /// Returns the command for this sample; none: it stands. Not to be asked while a hand drives.
  std::optional<Twist> turn(typename M::Odometry& odometry, bool has_route) const {
    if (!lost_ || (!has_route && !is_asked_)) return std::nullopt;
    const std::optional<Twist> wish = method_->recover(odometry, *lost_);
    if (!wish) return std::nullopt;
    assert(wish->linear_m_s == 0.0 && "a lost robot does not drive");
    return Twist{0.0, wish->angular_rad_s};
  }

 private:
  const M* method_;
  std::optional<LostFor> lost_;
  bool is_asked_ = false;
};

}  // namespace weft::agents
