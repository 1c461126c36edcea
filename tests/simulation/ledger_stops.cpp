#include <cmath>

#include "tests/simulation/ledger.hpp"

/// Checks that robots stand when they have to, and are as slow as they have to be.
namespace weft::simulation {

namespace {

bool is_free_to_drive(msg::RobotMode mode) {
  return mode == msg::RobotMode::idle || mode == msg::RobotMode::driving || mode == msg::RobotMode::waiting;
}

}  // namespace

/// Notes what the robot answers to people who stop it and let it go on. It may not say meanwhile that it is free to
/// drive, whatever happened to its agent: it would be given the next goal.
void Ledger::note_stops(Robot& by, const msg::Message& sent) {
  if (const auto* const state = std::get_if<msg::RobotState>(&sent)) {
    if ((by.is_stopped || by.had_emergency) && is_free_to_drive(state->mode))
      broken("stops", by.name + " says that it is " + to_string(state->mode) + " though nobody has let it go on");
  }
  const auto* const reply = std::get_if<msg::AgentReply>(&sent);
  if (reply == nullptr || !reply->done || !by.commands.contains(reply->command)) return;
  const msg::AgentCommand::Kind kind = by.commands.at(reply->command);
  if (kind == msg::AgentCommand::Kind::stop) by.is_stopped = true;
  if (kind == msg::AgentCommand::Kind::resume) by.is_stopped = by.had_emergency = false;
}

/// Checks that a robot which a person has to let go on does not drive, whatever happens to its agent meanwhile.
void Ledger::check_stops(Robot& by, const agents::Sample& sample, const agents::Twist& command) {
  by.had_emergency = by.had_emergency || sample.safety == Safety::emergency_stop;
  const bool has_to_stand = by.is_stopped || by.had_emergency || is_stop(sample.safety);
  if (!has_to_stand || by.body->by_hand() || command == agents::Twist{}) return;
  broken("stops", by.name + " drives at " + std::to_string(command.linear_m_s) + " m/s though " +
                      (by.is_stopped ? "an operator has stopped it" : "its base stopped it") +
                      (is_stop(sample.safety) ? "" : " and nobody has let it go on"));
}

/// Checks that who has been in a piece with a limit for a while drives no faster.
void Ledger::check_limits(const Robot& by) {
  constexpr double here_m = 0.1;
  constexpr double slows_down_m = 0.75;
  constexpr double more_m_s = 0.03;
  const std::optional<Route> route = by.agent->route();
  if (!route || !by.had || route->version != by.had->version || route->id != by.had->id) return;
  const Eigen::Vector2d at = by.body->site_from_robot().translation();
  const double speed_m_s = std::abs(by.body->true_speed_m_s());
  for (const SpeedLimit& limit : route->limits) {
    double inside_m = 0.0;
    std::optional<Pose2> before;
    for (std::uint32_t i = limit.from; i <= limit.to && i < route->places.size(); ++i) {
      const std::optional<Pose2> place = truth_of(route->places[i]);
      if (!place) continue;
      if (before) inside_m += (place->translation() - before->translation()).norm();
      before = place;
      if (inside_m < slows_down_m || i < by.passed || (place->translation() - at).norm() > here_m) continue;
      if (speed_m_s <= limit.limit_m_s + more_m_s) return;
      broken("limits", by.name + " drives at " + std::to_string(speed_m_s) + " m/s where its route says at most " +
                           std::to_string(limit.limit_m_s));
      return;
    }
  }
}

}  // namespace weft::simulation
