#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

#include "agents/agent/robot_agent.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kPlaceAtMost = 15s;
/// As near as this, a label on an existing place means here.
constexpr double kHereM = 0.05;
constexpr double kHereRad = 3.0 * std::numbers::pi / 180.0;

std::string where(const Estimate& estimate) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%.2f m and %.1f degrees from place %s",
                distance_m(estimate.place_from_robot),
                heading_rad(estimate.place_from_robot) * 180.0 / std::numbers::pi, to_string(estimate.place).c_str());
  return text.data();
}
}  // namespace

ExperienceId RobotAgent::new_experience() {
  ExperienceId experience;
  while (!experience) experience = ExperienceId{random_.next()};
  return experience;
}

void RobotAgent::keep_place(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now) {
  if (teaching_.has_value()) {
    if (teaching_->phase != Teaching::Phase::on) return refuse(key, "teaching has not begun or is ending: try again");
    keeping_.push_back(key);
    keeping_until_ = now + kPlaceAtMost;
    navigator_->keep_place();
    return;
  }
  const std::optional<Estimate> estimate = navigator_->estimate();
  if (!estimate.has_value() || lost_) {
    return refuse(key, config_.name + " does not know where it is: localise it, or label while teaching");
  }
  const bool here = distance_m(estimate->place_from_robot) <= kHereM &&
                    std::abs(heading_rad(estimate->place_from_robot)) <= kHereRad;
  if (here && replica_.window().place(estimate->place) != nullptr) {
    msg::AgentReply done;
    done.done = true;
    done.place = estimate->place;
    return reply(key, done);
  }
  if (keeping_alone_.has_value()) refuse(keeping_alone_->asked_by, "another label was asked for meanwhile");
  keeping_alone_ = KeepingAlone{.asked_by = key, .name = command.name, .deadline = now + kPlaceAtMost};
}

/// The newest view may do; if not, the next one, until the deadline.
void RobotAgent::try_keep_alone(SteadyTime now) {
  if (!keeping_alone_.has_value() || teaching_.has_value()) return;
  const TeachStart start{.experience = new_experience(), .robot = config_.self};
  const OrRefusal<Kept> kept = navigator_->keep_alone(start, map_view());
  if (!kept) {
    keeping_alone_->refused = kept.error().reason;
    return;
  }
  const KeepingAlone wanted = *std::exchange(keeping_alone_, std::nullopt);
  if (Result<void> handed_in = hand_in_alone(start, *kept, wanted.name, now); !handed_in) {
    return refuse(wanted.asked_by, handed_in.error().message);
  }
  msg::AgentReply done;
  done.done = true;
  done.place = kept->place.id;
  done.experience = start.experience;
  reply(wanted.asked_by, done);
}

/// An experience of its own, sealed at once: on the robot's disk when this returns.
Result<void> RobotAgent::hand_in_alone(const TeachStart& start, const Kept& kept, const std::string& name,
                                       SteadyTime now) {
  spooler_.begin(start.experience, name);
  cache_.put(kept.place.content.hash, kept.content);
  const Result<void> added = spooler_.add(kept, now);
  const Result<void> sealed = spooler_.seal("a place to name", now);
  return added ? sealed : added;
}

void RobotAgent::give_up_keeping(SteadyTime now) {
  if (!keeping_.empty() && now >= keeping_until_) {
    for (const CommandKey& key : std::exchange(keeping_, {})) {
      refuse(key, "nothing that is worth keeping was seen here for 15 s: move a little and try again");
    }
  }
  if (!keeping_alone_.has_value() || now < keeping_alone_->deadline) return;
  const KeepingAlone wanted = *std::exchange(keeping_alone_, std::nullopt);
  const std::optional<Estimate> estimate = navigator_->estimate();
  refuse(wanted.asked_by, config_.name + " is " + (estimate.has_value() ? where(*estimate) : "nowhere it knows") +
                              " and what it saw for 15 s could not be joined to the map (" + wanted.refused +
                              "): move it nearer to a taught way and along it, or label while teaching");
}

}  // namespace weft::agents
