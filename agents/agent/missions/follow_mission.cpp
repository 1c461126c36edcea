#include "agents/agent/missions/follow_mission.hpp"

#include <algorithm>

#include "agents/agent/missions/waits.hpp"
#include "agents/agent/surroundings.hpp"

namespace weft::agents {
namespace {
constexpr std::uint32_t kRouteAhead = 10;  ///< places of a route to have before driving it
}  // namespace

FollowMission::Took FollowMission::take(const Route& order, bool is_stopped, SteadyTime now) {
  const bool same_route = has_route() && route()->id == order.id;
  switch (task_.take(order, now)) {
    case RouteTask::Took::ignored:
      return Took::nothing;
    case RouteTask::Took::ended:
      uses_.navigator.stop();
      is_pending_ = false;
      return Took::end;
    case RouteTask::Took::renewed:
      renew(same_route, is_stopped, now);
      return Took::route;
    case RouteTask::Took::extended:
      if (!is_pending_ && !is_stopped) uses_.navigator.follow(*route(), task_.at());
      break;
  }
  return Took::nothing;
}

void FollowMission::renew(bool same_route, bool is_stopped, SteadyTime now) {
  if (same_route && !is_pending_ && !is_stopped) return uses_.navigator.follow(*route(), task_.at());
  if (!is_pending_) uses_.navigator.stop();
  is_pending_ = true;
  at_latest_ = now + kMapAtMost;
}

void FollowMission::step(const Navigated& navigated, bool is_stopped, SteadyTime now) {
  stray_.reset();
  if (!has_route() || is_pending_ || is_stopped) return;
  task_.set_progress(navigated.route_at, navigated.route_freed, now);
  stray_.look(navigated.following, navigated.reason);
  report(navigated, now);
}

void FollowMission::report(const Navigated& navigated, SteadyTime now) {
  const std::string why(navigated.reason);
  if (navigated.lost) return task_.set(msg::RoutePhase::stopped, "lost: " + why, now);
  switch (navigated.following) {
    case Following::none:
      return;
    case Following::driving:
      return task_.set(msg::RoutePhase::driving, {}, now);
    case Following::waiting:
      return task_.set(msg::RoutePhase::waiting, route()->reason.empty() ? why : route()->reason, now);
    case Following::stopped:
      return task_.set(msg::RoutePhase::stopped, why, now);
    case Following::failed:
      return task_.set(msg::RoutePhase::failed, why, now);
    case Following::arrived:
      return arrive(now);
  }
}

void FollowMission::arrive(SteadyTime now) {
  if (task_.arrived()) return;
  if (const std::optional<Estimate> estimate = uses_.navigator.estimate(); estimate.has_value()) {
    const std::optional<Relation> seen =
        seen_from(uses_.map.window(), route()->places.back(), estimate->place, estimate->place_from_robot);
    if (seen.has_value()) task_.set_arrival(*seen);
  }
  task_.set(msg::RoutePhase::arrived, {}, now);
}

void FollowMission::tick(bool may_drive, SteadyTime now) {
  waits_for_.clear();
  if (!is_pending_ || !may_drive) return;
  if (!uses_.navigator.estimate().has_value()) {
    waits_for_ = "does not know where it is: looks for itself";
    at_latest_ = now + kMapAtMost;
  } else {
    const bool covered =
        uses_.map.replica().is_settled() && is_covered(uses_.map.view(), *route(), task_.at(), kRouteAhead);
    if (covered || now >= at_latest_) {
      is_pending_ = false;
      uses_.navigator.follow(*route(), task_.at());
      return;
    }
    waits_for_ = "waits for the map of its route";
  }
  task_.set(msg::RoutePhase::waiting, waits_for_, now);
}

void FollowMission::stop(const std::string& reason, SteadyTime now) {
  is_pending_ = is_under_way();
  task_.set(msg::RoutePhase::stopped, reason, now);
}

void FollowMission::fail(const std::string& reason, SteadyTime now) {
  task_.set(msg::RoutePhase::failed, reason, now);
}

void FollowMission::await_localisation(SteadyTime now) {
  if (!is_under_way()) return;
  is_pending_ = true;
  at_latest_ = now + kMapAtMost;
}

bool FollowMission::give_back_if_astray() {
  if (!has_route() || !stray_.gives_back(route()->goal)) return false;
  uses_.outbox.note("it found itself off its route: it asks for another one from where it stands");
  task_.give_back();
  uses_.navigator.stop();
  is_pending_ = false;
  return true;
}

std::optional<SteadyTime> FollowMission::next(bool may_drive) const {
  std::optional<SteadyTime> next = task_.next();
  if (is_pending_ && may_drive) next = next.has_value() ? std::min(*next, at_latest_) : at_latest_;
  return next;
}

}  // namespace weft::agents
