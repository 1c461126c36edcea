#include <algorithm>
#include <set>
#include <utility>

#include "agents/agent/robot_agent.hpp"
#include "agents/agent/surroundings.hpp"
#include "core/network/search.hpp"

/// Looking for oneself anywhere: the server proposes places of the whole network, and the window is made of them.
namespace weft::agents {
namespace {

constexpr std::uint32_t kAroundHops = 3;     ///< of a suspected place: enough to confirm it
constexpr std::uint32_t kAroundPlaces = 50;  ///< where many robots have driven

/// The contents of `first` before all others.
std::vector<ContentRef> put_first(const std::vector<PlaceId>& first, const Window& window,
                                  const std::vector<ContentRef>& others) {
  std::vector<ContentRef> all;
  all.reserve(others.size());
  std::set<ContentHash> taken;
  const auto take = [&](const ContentRef& content) {
    if (taken.insert(content.hash).second) all.push_back(content);
  };
  for (const PlaceId& id : first) {
    if (const Place* const place = window.place(id); place != nullptr) take(place->content);
  }
  std::for_each(others.begin(), others.end(), take);
  return all;
}

}  // namespace

void RobotAgent::on(const msg::Recognised& answer, SteadyTime now) {
  std::optional<Recogniser::Heard> heard = recogniser_.on_answer(answer);
  if (!heard.has_value()) return;
  if (heard->note != proposals_noted_) output_.notes.push_back(heard->note);
  proposals_noted_ = std::move(heard->note);
  navigator_->propose(heard->question, heard->places);
  look_at(std::move(heard->places), now);
}

void RobotAgent::look_at(std::vector<PlaceId> places, SteadyTime now) {
  proposed_ = std::move(places);
  define_for_proposed(now);
}

/// What is to be held whatever the window is around.
std::vector<PlaceId> RobotAgent::always_held() const {
  std::vector<PlaceId> held = task_.route().has_value() ? task_.route()->places : std::vector<PlaceId>{};
  held.insert(held.end(), proposed_.begin(), proposed_.end());
  return held;
}

/// A robot that knows nothing of where it is needs the proposed places, and what lies around one that it suspects.
/// One that has an idea, is being taught, or holds the whole network anyway, needs them beside what it has.
void RobotAgent::define_for_proposed(SteadyTime now) {
  WindowDefinition definition = usual_window();
  const bool holds_all =
      !definition.centre.has_value() && !is_for_proposed_ && replica_.window().places.size() < config_.window_cap;
  const bool knows_something = navigator_->estimate().has_value() || teaching_.has_value();
  is_for_proposed_ = !proposed_.empty() && !holds_all && !knows_something;
  if (is_for_proposed_) {
    definition.centre = suspected_.has_value() ? *suspected_ : proposed_.front();
    definition.hops = kAroundHops;
    definition.cap = static_cast<std::uint32_t>(definition.route.size()) + kAroundPlaces;
  }
  replica_.define(std::move(definition), now);
  want_contents(now);
}

/// As it would be without proposed places, but for them.
WindowDefinition RobotAgent::usual_window() const {
  WindowDefinition definition = replica_.definition();
  if (is_for_proposed_) {
    definition.centre.reset();
    definition.hops = config_.window_hops;
    definition.cap = config_.window_cap;
  }
  definition.route = always_held();
  return definition;
}

void RobotAgent::follow_search(bool has_fix, SteadyTime now) {
  recogniser_.want(navigator_->question(), now);
  const std::optional<PlaceId> suspected = navigator_->suspected();
  if (has_fix && !proposed_.empty()) {
    suspected_.reset();
    forget_proposed();
    WindowDefinition definition = usual_window();
    if (std::exchange(is_for_proposed_, false)) {
      if (const std::optional<Estimate> found = navigator_->estimate()) definition.centre = found->place;
    }
    return replica_.define(std::move(definition), now);
  }
  if (suspected == suspected_) return;
  suspected_ = suspected;
  if (!proposed_.empty() && suspected_.has_value()) define_for_proposed(now);
}

void RobotAgent::forget_proposed() {
  proposed_.clear();
  proposals_noted_.clear();
}

std::vector<ContentRef> RobotAgent::proposed_first(std::vector<ContentRef> contents) const {
  if (proposed_.empty()) return contents;
  std::vector<PlaceId> first;
  if (suspected_.has_value()) first = neighbourhood(replica_.window(), *suspected_, kAroundHops, kAroundPlaces);
  first.insert(first.end(), proposed_.begin(), proposed_.end());
  return put_first(first, replica_.window(), contents);
}

}  // namespace weft::agents
