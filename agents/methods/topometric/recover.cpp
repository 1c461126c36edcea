// Looking around where the robot is lost (contract, T5; Dayoub et al. 2013, III-D).
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {

static_assert(Recovers<Topometric>);

std::optional<Twist> Topometric::recover(Odometry& odometry, const LostFor& lost) const {
  const Planned planned = plan_next(config_.plan, odometry.plan, PlanEvent::is_lost, odometry.time, lost.turned_rad);
  odometry.plan = planned.state;
  odometry.steering = {};
  switch (planned.effect) {
    case PlanEffect::clear_costmap:
      if (odometry.costmap) odometry.costmap->clear();
      return Twist{};
    case PlanEffect::look_around:
      return Twist{0.0, config_.plan.recover_rad_s};
    default:
      return std::nullopt;
  }
}

}  // namespace weft::agents
