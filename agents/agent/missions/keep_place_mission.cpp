#include "agents/agent/missions/keep_place_mission.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kPlaceAtMost = 15s;
/// Bounds how far an existing place may be for a label on it to mean here.
constexpr double kHereM = 0.05;
constexpr double kHereRad = 3.0 * std::numbers::pi / 180.0;

bool is_here(const Estimate& estimate) {
  return distance_m(estimate.place_from_robot) <= kHereM &&
         std::abs(heading_rad(estimate.place_from_robot)) <= kHereRad;
}

std::string where(const Estimate& estimate) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%.2f m and %.1f degrees from place %s",
                distance_m(estimate.place_from_robot),
                heading_rad(estimate.place_from_robot) * 180.0 / std::numbers::pi, to_string(estimate.place).c_str());
  return text.data();
}
}  // namespace

void KeepPlaceMission::start(const msg::AgentCommand& command, const CommandKey& key, bool is_lost, SteadyTime now) {
  const std::optional<Estimate> estimate = uses_.navigator.estimate();
  if (!estimate.has_value() || is_lost) {
    return uses_.replies.refuse(
        key, uses_.config.name + " does not know where it is: localise it, or label while teaching");
  }
  if (is_here(*estimate) && uses_.map.window().place(estimate->place) != nullptr) {
    msg::AgentReply done = carried_out();
    done.place = estimate->place;
    return uses_.replies.give(key, std::move(done));
  }
  if (wanted_.has_value()) uses_.replies.refuse(wanted_->asked_by, "another label was asked for meanwhile");
  wanted_ = Wanted{.asked_by = key, .name = command.name, .deadline = now + kPlaceAtMost};
}

void KeepPlaceMission::on_view(SteadyTime now) {
  if (!wanted_.has_value()) return;
  const TeachStart start{.experience = uses_.ids.next(), .robot = uses_.config.self};
  const OrRefusal<Kept> kept = uses_.navigator.keep_alone(start, uses_.map.view());
  if (!kept) {
    wanted_->refused = kept.error().reason;
    return;
  }
  const Wanted wanted = *std::exchange(wanted_, std::nullopt);
  if (Result<void> handed_in = hand_in(start, *kept, wanted.name, now); !handed_in) {
    return uses_.replies.refuse(wanted.asked_by, handed_in.error().message);
  }
  msg::AgentReply done = carried_out();
  done.place = kept->place.id;
  done.experience = start.experience;
  uses_.replies.give(wanted.asked_by, std::move(done));
}

/// Spools an experience of its own, sealed at once: it is on the robot's disk when this returns.
Result<void> KeepPlaceMission::hand_in(const TeachStart& start, const Kept& kept, const std::string& name,
                                       SteadyTime now) {
  uses_.spooler.begin(start.experience, name);
  uses_.map.put(kept.place.content.hash, kept.content);
  const Result<void> added = uses_.spooler.add(kept, now);
  const Result<void> sealed = uses_.spooler.seal("a place to name", now);
  return added ? sealed : added;
}

void KeepPlaceMission::tick(SteadyTime now) {
  if (!wanted_.has_value() || now < wanted_->deadline) return;
  const Wanted wanted = *std::exchange(wanted_, std::nullopt);
  const std::optional<Estimate> estimate = uses_.navigator.estimate();
  uses_.replies.refuse(wanted.asked_by,
                       uses_.config.name + " is " + (estimate.has_value() ? where(*estimate) : "nowhere it knows") +
                           " and what it saw for 15 s could not be joined to the map (" + wanted.refused +
                           "): move it nearer to a taught way and along it, or label while teaching");
}

std::optional<SteadyTime> KeepPlaceMission::next() const {
  return wanted_.has_value() ? std::optional(wanted_->deadline) : std::nullopt;
}

void KeepPlaceMission::was_away(Duration away) {
  if (wanted_.has_value()) wanted_->deadline += away;
}

}  // namespace weft::agents
