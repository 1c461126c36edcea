#include "tests/simulation/ledger.hpp"

#include <cmath>

#include "core/network/codec.hpp"

namespace weft::simulation {

void Ledger::broken(const std::string& invariant, const std::string& what) {
  if (said_.insert(invariant + what).second) violations_.push_back({invariant, what});
}

std::optional<Pose2> Ledger::truth_of(const PlaceId& place) const {
  const auto found = truth_.find(place);
  return found == truth_.end() ? std::nullopt : std::optional(found->second);
}

void Ledger::agent_sent(const RobotId& robot, const msg::Message& message) {
  Robot& by = robots.at(robot);
  if (const auto* state = std::get_if<msg::RobotState>(&message)) by.state = *state;
  if (const auto* request = std::get_if<msg::WindowRequest>(&message)) by.wants = request->definition;
  if (const auto* sent = std::get_if<msg::ExperienceBatch>(&message)) {
    const auto [known, first] = sent_[sent->batch.experience].emplace(sent->batch.sequence, sent->batch);
    if (!first && hash(known->second) != hash(sent->batch)) {
      broken("acknowledged",
             by.name + " sent two different batches under sequence " + std::to_string(sent->batch.sequence));
    }
    for (const Place& place : sent->batch.places) {
      if (const auto at = by.body->at_frame(place.frame)) truth_.emplace(place.id, *at);
    }
  }
}

void Ledger::agent_heard(const RobotId& robot, const msg::Message& message, const storage::MemoryDisk& disk) {
  const auto* ack = std::get_if<msg::BatchAck>(&message);
  if (ack == nullptr || ack->to != robot) return;
  std::uint64_t& through = acknowledged_[ack->experience];
  for (; through < ack->durable_through; ++through, ++acknowledged_count_) {
    if (!disk.batch_hashes.contains({ack->experience, through + 1})) {
      broken("acknowledged", "batch " + std::to_string(through + 1) + " of " + to_string(ack->experience) +
                                 " was acknowledged and is not on the disk");
    }
  }
}

void Ledger::server_heard(const msg::Message& message) {
  if (const auto* state = std::get_if<msg::RobotState>(&message)) known_[state->header.sender] = *state;
  if (const auto* progress = std::get_if<msg::RouteProgress>(&message)) {
    const auto held = held_.find(progress->header.sender);
    if (held == held_.end() || held->second.route.id != progress->route) return;
    if (progress->version == held->second.route.version) {
      held->second.from = std::max(held->second.from, std::min(progress->freed, held->second.route.released));
    }
    if (progress->phase == msg::RoutePhase::arrived) held->second.from = held->second.route.released;
  }
}

void Ledger::server_sent(const msg::Message& message, const server::Service& service) {
  if (const auto* order = std::get_if<msg::RouteOrder>(&message)) {
    if (!order->route.ended) check_release(order->route);
    auto& version = robots.at(order->to).told[order->route.goal][order->route.id];
    version = std::max(version, order->route.version);
  }
  if (const auto* reply = std::get_if<msg::OperatorReply>(&message)) {
    const bool accepted = reply->outcome == msg::Outcome::accepted || reply->outcome == msg::Outcome::done;
    if (reply->goal && accepted) {
      bool stored = false;
      for (const Goal& goal : service.goals()) stored = stored || goal.id == reply->goal;
      if (!stored) broken("goals", "goal " + to_string(reply->goal) + " was accepted and is not stored");
    }
  }
}

void Ledger::client_heard(const msg::Message& message) {
  const auto* reply = std::get_if<msg::OperatorReply>(&message);
  if (reply == nullptr || !reply->goal) return;
  if (reply->outcome == msg::Outcome::accepted || reply->outcome == msg::Outcome::done) accepted_.insert(reply->goal);
}

/// A new piece of released route keeps clear of every other robot that the server knows the place of.
void Ledger::check_release(const Route& route) {
  const auto before = held_.find(route.robot);
  const bool continued =
      before != held_.end() && before->second.route.id == route.id && before->second.route.version == route.version;
  const std::uint32_t known_through = continued ? before->second.route.released : 0;
  const double apart = 2.0 * footprint_m_ - 0.15;  // what localisation may be off by
  for (std::uint32_t i = continued ? known_through + 1 : 0; i <= route.released && i < route.places.size(); ++i) {
    const auto here = truth_of(route.places[i]);
    if (!here) continue;
    for (const auto& [other, stretch] : held_) {
      if (other == route.robot) continue;
      for (std::uint32_t k = stretch.from; k <= stretch.route.released && k < stretch.route.places.size(); ++k) {
        const auto there = truth_of(stretch.route.places[k]);
        if (there && (here->translation() - there->translation()).norm() < apart) {
          broken("occupancy", robots.at(route.robot).name + " was released to " + to_string(route.places[i]) +
                                  " which " + robots.at(other).name + " holds at " +
                                  to_string(stretch.route.places[k]));
          k = stretch.route.released;
        }
      }
    }
  }
  Stretch& mine = held_[route.robot];
  mine = {route, continued ? mine.from : 0};
}

void Ledger::agent_stepped(const RobotId& robot, const agents::AgentOutput& output) {
  const Robot& by = robots.at(robot);
  const bool lost = by.state.mode == msg::RobotMode::lost;
  if (lost && !by.body->by_hand() && output.command != agents::Twist{}) {
    broken("lost_stands",
           by.name + " says that it is lost and drives at " + std::to_string(output.command.linear_m_s) + " m/s");
  }
  if (lost && !by.body->by_hand() && by.state.blind_m > 4.0) {
    broken("lost_stands", by.name + " has driven " + std::to_string(by.state.blind_m) + " m blind");
  }
  if (!by.body->by_hand()) {
    check_released_point(by);
    check_belief(by);
  }
}

/// By the truth: a robot on a route is not ahead of the released place.
void Ledger::check_released_point(const Robot& robot) {
  if (robot.agent == nullptr || std::abs(robot.body->true_speed_m_s()) < 0.01) return;
  const auto held = held_.find(robot.body != nullptr ? robot.state.header.sender : RobotId{});
  if (held == held_.end()) return;
  const Route& route = held->second.route;
  if (robot.state.route != route.id || route.released + 1 >= route.places.size()) return;
  const auto at = truth_of(route.places[route.released]);
  if (!at) return;
  const Pose2 beyond = at->inverse() * robot.body->site_from_robot();
  if (beyond.x > 0.25 && beyond.x < 1.0 && std::abs(beyond.y) < 0.4) {
    broken("released_point", robot.name + " is " + std::to_string(beyond.x) + " m beyond its released place " +
                                 to_string(route.places[route.released]));
  }
}

/// A robot that drives by itself is where it believes to be.
void Ledger::check_belief(const Robot& robot) {
  if (robot.agent == nullptr || robot.body->true_speed_m_s() < 0.2) return;
  const auto estimate = robot.agent->estimate();
  if (!estimate) return;
  const auto place = truth_of(estimate->place);
  if (!place) return;
  const Pose2 off = (*place * planar(estimate->place_from_robot)).inverse() * robot.body->site_from_robot();
  if (off.translation().norm() > 0.4) {
    broken("belief",
           robot.name + " drives " + std::to_string(off.translation().norm()) + " m from where it believes to be");
  }
}

}  // namespace weft::simulation
