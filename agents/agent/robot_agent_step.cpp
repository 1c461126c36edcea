#include <cmath>
#include <utility>

#include "agents/agent/robot_agent.hpp"
#include "agents/agent/surroundings.hpp"
#include "core/network/search.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr std::uint32_t kDriftHops = 8;  ///< the window moves when the robot is farther than this from its centre
constexpr Duration kBetweenMoves = 1s;   ///< of the window
constexpr std::uint32_t kGroundPlaces = 1000;

double speed(const Motion& motion) {
  const double elapsed = seconds(motion.elapsed);
  if (motion.wheels.has_value() && elapsed > 0.0) return motion.wheels->distance_m / elapsed;
  return motion.command.linear_m_s;
}
}  // namespace

AgentOutput RobotAgent::step(const Sample& sample, SteadyTime now) {
  frame_ = sample.frame;
  speed_m_s_ = speed(sample.motion);
  Navigated navigated = navigator_->step(sample, map_view());
  lost_ = navigated.lost;
  stands_for_ = navigated.reason;
  command_ = navigated.command;
  output_.exposes = navigated.exposes;
  keep(navigated.kept, now);
  note_lessons(std::move(navigated.lessons), sample.time);
  if (teaching_.has_value()) {
    teaching_->hand_done = sample.hand_done;
    if (teaching_->phase == Teaching::Phase::ending) keep(navigator_->end_teach(map_view()), now);
  }
  // The spool may not have taken it.
  if (teaching_.has_value() && teaching_->phase == Teaching::Phase::ending && !navigator_->is_taught()) {
    end_teaching(now);
  }
  for (const Refusal& refusal : navigated.refusals) ++seen_["navigation: " + std::string(refusal.reason)];
  if (navigated.fix.has_value()) {
    ++seen_["navigation: fixes"];
    note_fix(*navigated.fix, now);
    if (const std::optional<double> lift = navigated.fix->evidence.lift_m; lift.has_value()) {
      note_lift(navigated.fix->place.experience, *lift);
    }
  }
  if (!sample.views.empty()) try_keep_alone(now);
  follow_search(navigated.fix.has_value(), now);
  note_following(navigated, now);
  recentre(now);
  return finish(now);
}

void RobotAgent::note_lift(const ExperienceId& experience, double lift_m) {
  const bool was_well = lift_.notice().empty();
  lift_.add(experience, lift_m);
  if (was_well == lift_.notice().empty()) return;
  output_.notes.push_back(was_well ? lift_.notice() : "its camera stands as high as its places say again");
}

void RobotAgent::note_following(const Navigated& navigated, SteadyTime now) {
  strays_ = false;
  if (!task_.route().has_value() || follow_pending_ || stopped_) return;
  task_.set_progress(navigated.route_at, navigated.route_freed, now);
  const std::string why(navigated.reason);
  strays_ = navigated.following == Following::stopped && (why == "off_route" || why == "route_not_joined");
  if (navigated.lost) return task_.set(msg::RoutePhase::stopped, "lost: " + why, now);
  switch (navigated.following) {
    case Following::none:
      return;
    case Following::driving:
      return task_.set(msg::RoutePhase::driving, {}, now);
    case Following::waiting:
      return task_.set(msg::RoutePhase::waiting, task_.route()->reason.empty() ? why : task_.route()->reason, now);
    case Following::stopped:
      return task_.set(msg::RoutePhase::stopped, why, now);
    case Following::failed:
      return task_.set(msg::RoutePhase::failed, why, now);
    case Following::arrived:
      break;
  }
  if (task_.arrived()) return;
  const std::optional<Estimate> estimate = navigator_->estimate();
  if (estimate.has_value()) {
    const std::optional<Relation> seen =
        seen_from(replica_.window(), task_.route()->places.back(), estimate->place, estimate->place_from_robot);
    if (seen.has_value()) task_.set_arrival(*seen);
  }
  task_.set(msg::RoutePhase::arrived, {}, now);
}

void RobotAgent::recentre(SteadyTime now) {
  const std::optional<Estimate> estimate = navigator_->estimate();
  if (!estimate.has_value() || estimate->place == focus_ || now - focused_at_ < kBetweenMoves) return;
  focus_ = estimate->place;
  focused_at_ = now;
  if (cache_.missing() > 0) want_contents(now);
  const Window& window = replica_.window();
  // While teaching, everything that the network has is of use, as long as it fits: any of it may be met.
  const bool all_fits = !replica_.definition().centre.has_value() && window.places.size() < config_.window_cap;
  if (!replica_.is_settled() || (teaching_.has_value() && all_fits)) return;
  if (teaching_.has_value() && !std::exchange(teaching_->asked_for_all, true)) {
    WindowDefinition definition = replica_.definition();
    definition.centre.reset();
    return replica_.define(std::move(definition), now);
  }
  std::optional<PlaceId> centre;
  if (window.place(focus_) != nullptr) {
    centre = focus_;
  } else if (const auto durable = spooler_.newest_durable(focus_.experience); durable) {
    centre = durable;
  }
  if (!centre.has_value()) return;
  const std::optional<PlaceId>& old = replica_.definition().centre;
  if (old.has_value() && is_near(window, *old, *centre, kDriftHops)) return;
  WindowDefinition definition = replica_.definition();
  definition.centre = centre;
  replica_.define(std::move(definition), now);
}

/// The place on which the robot knows where it is can leave the window: an edit has taken it out of the map, or the
/// window is of another part by now. Which of the two, and what beside it is left, shows when exactly that is asked
/// for.
void RobotAgent::keep_ground(SteadyTime now) {
  // Who looks for himself around a seed asks for another part of the map on purpose.
  const bool goes_elsewhere = localising_.has_value() && localising_->seed.has_value();
  if (teaching_.has_value() || goes_elsewhere) return ground_.reset();
  const std::optional<Estimate> estimate = navigator_->estimate();
  WindowDefinition definition = replica_.definition();
  if (!ground_.has_value()) {
    const Window& before = replica_.before();
    const bool has_left = estimate.has_value() && before.place(estimate->place) != nullptr &&
                          replica_.window().place(estimate->place) == nullptr;
    if (!has_left) return;
    ground_ = before;
    definition.centre.reset();
    definition.route =
        neighbourhood(*ground_, estimate->place, static_cast<std::uint32_t>(before.places.size()), kGroundPlaces);
    return replica_.define(std::move(definition), now);
  }
  if (navigator_->map_changed(*ground_, replica_.window())) {
    if (const auto found = navigator_->estimate()) definition.centre = found->place;
  } else {
    navigator_->forget_where();
    output_.notes.push_back("what it knew around " + to_string(estimate->place) +
                            " was taken out of the map: it does not know where it is");
  }
  ground_.reset();
  definition.route = always_held();
  replica_.define(std::move(definition), now);
}

void RobotAgent::want_contents(SteadyTime now) {
  std::optional<PlaceId> focus;
  if (replica_.window().place(focus_) != nullptr) {
    focus = focus_;
  } else {
    focus = replica_.definition().centre;
  }
  const std::vector<std::string> methods = navigator_->teaches();
  cache_.want(proposed_first(nearest_first(replica_.window(), methods, focus, task_.route(), 0)), now);
}

}  // namespace weft::agents
