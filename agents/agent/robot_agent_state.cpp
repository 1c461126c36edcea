#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/agent/robot_agent.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kMoving = 500ms;
constexpr Duration kIdle = 3s;
constexpr Duration kBetweenStates = 100ms;
constexpr double kMovingFasterThan = 0.01;  // m/s
}  // namespace

msg::RobotMode RobotAgent::mode() const {
  if (!fault_.empty()) return msg::RobotMode::faulted;
  if (teaching_.has_value()) return msg::RobotMode::teaching;
  if (stopped_) return msg::RobotMode::stopped;
  if (lost_) return msg::RobotMode::lost;
  if (!task_.route().has_value() || task_.arrived()) return msg::RobotMode::idle;
  return task_.phase() == msg::RoutePhase::driving ? msg::RobotMode::driving : msg::RobotMode::waiting;
}

std::string RobotAgent::reason() const {
  if (!session_.incompatible().empty()) return session_.incompatible();
  switch (mode()) {
    case msg::RobotMode::faulted:
      return fault_;
    case msg::RobotMode::teaching:
      if (stopped_) return "stopped by an operator";
      if (teaching_->phase == Teaching::Phase::preparing) return "waits for the map around its seed";
      if (teaching_->phase == Teaching::Phase::seeking) return "looks for itself around its seed";
      return teaching_->hand_done ? "hand_done" : std::string{};
    case msg::RobotMode::stopped:
      return "stopped by an operator";
    case msg::RobotMode::lost:
      return stands_for_;
    case msg::RobotMode::waiting:
      if (!waits_for_.empty()) return waits_for_;
      return task_.route()->reason.empty() ? stands_for_ : task_.route()->reason;
    case msg::RobotMode::idle:
      if (!teaching_failed_.empty()) return teaching_failed_;
      if (localising_.has_value() && !proposed_.empty()) {
        return "looks for itself among " + std::to_string(proposed_.size()) +
               " places that look like what it sees, " + recogniser_.among();
      }
      return localising_.has_value() ? "looks for itself" : lift_.notice();
    case msg::RobotMode::off:
    case msg::RobotMode::driving:
      break;
  }
  return lift_.notice();
}

std::string RobotAgent::mount() const {
  const std::optional<MountReport> report = navigator_->mount();
  return report.has_value() ? words_of(*report, lift_.lift_m()) : std::string{};
}

msg::RobotDescription RobotAgent::description() {
  msg::RobotDescription description;
  description.name = config_.name;
  description.body = config_.body;
  description.methods = navigator_->drives();
  description.footprint_radius_m = config_.footprint_radius_m;
  description.can_be_taught_along = config_.can_be_taught_along;
  description.cameras = config_.cameras;
  return description;
}

msg::RobotState RobotAgent::state() {
  msg::RobotState state;
  state.name = config_.name;
  state.mode = mode();
  if (const std::optional<Estimate> estimate = navigator_->estimate(); estimate.has_value()) {
    state.localised = !lost_;
    state.place = estimate->place;
    state.place_from_robot = estimate->place_from_robot;
    state.blind_m = estimate->blind_m;
  }
  state.speed_m_s = speed_m_s_;
  state.frame = frame_;
  if (teaching_.has_value()) state.experience = teaching_->experience;
  if (task_.route().has_value()) {
    state.goal = task_.route()->goal;
    state.route = task_.route()->id;
    state.route_version = task_.route()->version;
  }
  state.window_revision = replica_.window().revision;
  state.window_digest = replica_.digest();
  state.contents_missing = cache_.missing();
  state.memory_bytes = cache_.bytes();
  state.memory_cap_bytes = config_.content_cache_bytes;
  state.reason = reason();
  return state;
}

RobotAgent::Shown RobotAgent::shown() const {
  Shown shown;
  shown.mode = mode();
  shown.localised = navigator_->estimate().has_value() && !lost_;
  if (task_.route().has_value()) {
    shown.route = task_.route()->id;
    shown.version = task_.route()->version;
  }
  if (teaching_.has_value()) shown.experience = teaching_->experience;
  shown.window = replica_.digest();
  shown.complete = cache_.missing() == 0;
  shown.reason = reason();
  return shown;
}

bool RobotAgent::state_due(SteadyTime now) {
  Shown now_shown = shown();
  if (now_shown != said_) state_at_ = std::min(state_at_, state_sent_at_ + kBetweenStates);
  if (now < state_at_) return false;
  said_ = std::move(now_shown);
  state_sent_at_ = now;
  state_at_ = now + (std::abs(speed_m_s_) > kMovingFasterThan ? kMoving : kIdle);
  return true;
}

}  // namespace weft::agents
