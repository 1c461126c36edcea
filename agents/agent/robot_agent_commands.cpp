#include <utility>

#include "agents/agent/robot_agent.hpp"
#include "core/network/change.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kLastViewAtMost = 3s;
}  // namespace

void RobotAgent::reply(const CommandKey& key, const msg::AgentReply& given) {
  msg::AgentReply answer = given;
  answer.command = key.command;
  ledger_.answered(key, answer);
  send(std::move(answer));
}

void RobotAgent::refuse(const CommandKey& key, std::string reason) {
  msg::AgentReply refusal;
  refusal.reason = std::move(reason);
  reply(key, refusal);
}

void RobotAgent::teach_start(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now) {
  if (!fault_.empty()) return refuse(key, config_.name + " is out of order: " + fault_);
  if (teaching_.has_value()) return teach_on(command, key);
  if (task_.route().has_value()) {
    return refuse(key, config_.name + " has a goal: cancel it, or wait until it is there");
  }
  if (!command.along.empty() && !config_.can_be_taught_along) {
    return refuse(key, "this body (" + config_.body + ") has no hand that drives along a file: leave out --along");
  }
  if (stopped_) return refuse(key, config_.name + " is stopped: resume it first");
  Teaching teaching;
  handing_in_.reset();
  teaching.experience = new_experience();
  teaching.name = command.name;
  const std::vector<std::string> methods = navigator_->teaches();
  for (std::size_t i = 1; i < methods.size(); ++i) {
    teaching.others.push_back(new_experience());
    if (name_of_other(command.name, methods[i]).size() <= kLongestName) continue;
    return refuse(key, "'" + command.name + "' is too long for a name to which -" + methods[i] +
                           " is added: " + std::to_string(kLongestName) + " characters are the most");
  }
  teaching.seed = command.seed;
  for (const msg::AgentCommand::Point& point : command.along) teaching.along.push_back({point.x, point.y});
  teaching.started_by = key;
  teaching.deadline = now + kMapAtMost;
  localising_.reset();
  if (command.seed.has_value() || is_for_proposed_) {
    forget_proposed();
    WindowDefinition definition = usual_window();
    is_for_proposed_ = false;
    if (command.seed.has_value()) definition.centre = command.seed;
    replica_.define(std::move(definition), now);
  }
  teaching_ = std::move(teaching);
}

/// The same run asked for again: another line for the hand, or the repeat of a server that has forgotten that it
/// asked.
void RobotAgent::teach_on(const msg::AgentCommand& command, const CommandKey& key) {
  const bool same = !command.name.empty() && command.name == teaching_->name &&
                    teaching_->phase == Teaching::Phase::on && !teaching_->next_part.has_value();
  if (!same) return refuse(key, config_.name + " is being taught '" + teaching_->name + "': stop that first");
  std::vector<SitePoint> along;
  along.reserve(command.along.size());
  for (const msg::AgentCommand::Point& point : command.along) along.push_back({point.x, point.y});
  if (along.empty() || along == teaching_->along) {
    msg::AgentReply done;
    done.done = true;
    done.experience = teaching_->experience;
    return reply(key, done);
  }
  if (!config_.can_be_taught_along) return refuse(key, "this body (" + config_.body + ") has no hand");
  if (stopped_) return refuse(key, config_.name + " is stopped: resume it first");
  teaching_->along = std::move(along);
  teaching_->next_part = key;
  output_.hand_start = teaching_->along;
}

void RobotAgent::teach_stop(const CommandKey& key, SteadyTime now) {
  if (!teaching_.has_value()) return refuse(key, config_.name + " is not being taught");
  if (teaching_->phase == Teaching::Phase::ending) return refuse(key, config_.name + " is ending that already");
  if (teaching_->phase != Teaching::Phase::on) {
    refuse(teaching_->started_by, "stopped before the map around the seed was there");
    teaching_.reset();
    msg::AgentReply done;
    done.done = true;
    done.reason = "nothing was taught yet";
    return reply(key, done);
  }
  output_.hand_stop = true;
  teaching_->phase = Teaching::Phase::ending;
  teaching_->stopped_by = key;
  teaching_->deadline = now + kLastViewAtMost;
}

/// How what it was taught will be found again: the run that goes on, or the last one.
void RobotAgent::teach_report(const msg::AgentCommand& command, const CommandKey& key) {
  const Result<TaughtWay> way = navigator_->taught_way();
  if (!way) return refuse(key, way.error().message);
  if (!command.name.empty() && command.name != to_string(way->experience)) {
    return refuse(key, config_.name + " reports on what it was taught last, experience " +
                           to_string(way->experience) + ": leave the name out");
  }
  msg::AgentReply done;
  done.done = true;
  done.experience = way->experience;
  for (TaughtStretch& row : stretches_of(*way, msg::kReportRows)) {
    done.report.push_back({.from_m = row.from_m,
                           .to_m = row.to_m,
                           .places = row.places,
                           .first = row.first,
                           .as_is = row.found[static_cast<std::size_t>(Prospect::as_is)],
                           .half_light = row.found[static_cast<std::size_t>(Prospect::half_light)],
                           .worn = row.found[static_cast<std::size_t>(Prospect::worn)],
                           .sigma_m = row.sigma_m,
                           .reason = std::move(row.reason)});
  }
  if (done.report.empty()) {
    return refuse(key, config_.name + " has not tried any of its places yet: lead it on for half a metre, ask again");
  }
  reply(key, done);
}

void RobotAgent::tell_counts(const CommandKey& key) {
  msg::AgentReply done;
  done.done = true;
  for (const auto& [what, times] : counters()) done.counts.emplace_back(what, times);
  reply(key, done);
}

void RobotAgent::localise(const msg::AgentCommand& command, const CommandKey& key, SteadyTime now) {
  if (!fault_.empty()) return refuse(key, config_.name + " is out of order: " + fault_);
  if (teaching_.has_value()) return refuse(key, config_.name + " is being taught: stop that first");
  if (mode() == msg::RobotMode::driving) {
    return refuse(key, config_.name + " drives, and knows where it is: stop it or cancel its goal first");
  }
  if (localising_.has_value() && localising_->asked_by.has_value()) {
    refuse(*localising_->asked_by, "another search was asked for meanwhile");
  }
  start_localising(key, command.seed, now);
}

void RobotAgent::stop(const CommandKey& key, SteadyTime now) {
  stopped_ = true;
  navigator_->stop();
  follow_pending_ = task_.route().has_value() && !task_.arrived();
  task_.set(msg::RoutePhase::stopped, "stopped by an operator", now);
  if (teaching_.has_value()) output_.hand_stop = true;
  msg::AgentReply done;
  done.done = true;
  reply(key, done);
}

void RobotAgent::resume(const CommandKey& key, SteadyTime now) {
  if (stopped_) follow_at_latest_ = now;
  stopped_ = false;
  msg::AgentReply done;
  done.done = true;
  reply(key, done);
}

}  // namespace weft::agents
