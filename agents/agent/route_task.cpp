#include "agents/agent/route_task.hpp"

#include <algorithm>
#include <chrono>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenRouteReports = 200ms;
constexpr Duration kRepeat = 2s;
constexpr std::size_t kRoutesRemembered = 64;

/// Returns whether both lead by the same places through the one of that index.
bool begin_alike(const Route& a, const Route& b, std::uint32_t through) {
  if (through >= a.places.size() || through >= b.places.size()) return false;
  return std::equal(a.places.begin(), a.places.begin() + through + 1, b.places.begin());
}
}  // namespace

RouteTask::Took RouteTask::take(const Route& order, SteadyTime now) {
  const bool same = route_.has_value() && route_->id == order.id;
  if (order.ended) {
    end(order.id);
    if (!same) return Took::ignored;
    route_.reset();
    return Took::ended;
  }
  if (std::find(over_.begin(), over_.end(), order.id) != over_.end()) return Took::ignored;
  if (order.id == given_back_ && order.version <= given_back_version_) return Took::ignored;
  // The answer to any order, repeats too, is a report: it may be the report that was lost.
  touch(now);
  if (same && order.version < route_->version) return Took::ignored;
  if (same && order.version == route_->version) {
    if (order.released == route_->released) route_->reason = order.reason;
    if (order.released <= route_->released) return Took::ignored;
    route_->released = order.released;
    route_->reason = order.reason;
    return Took::extended;
  }
  if (route_.has_value() && !same) end(route_->id);
  // Forgets what has been passed, unless the next version begins alike: a route may come by one floor twice.
  if (!same || !begin_alike(*route_, order, at_)) at_ = freed_ = 0;
  route_ = order;
  phase_ = msg::RoutePhase::accepted;
  reason_.clear();
  goal_from_robot_ = Relation{};
  return Took::renewed;
}

void RouteTask::give_back() {
  if (!route_.has_value()) return;
  given_back_ = route_->id;
  given_back_version_ = route_->version;
  route_.reset();
}

void RouteTask::end(const RouteId& id) {
  if (std::find(over_.begin(), over_.end(), id) != over_.end()) return;
  over_.push_back(id);
  if (over_.size() > kRoutesRemembered) over_.pop_front();
}

void RouteTask::touch(SteadyTime now) {
  report_at_ = std::max(now, reported_at_ + kBetweenRouteReports);
}

void RouteTask::set(msg::RoutePhase phase, const std::string& reason, SteadyTime now) {
  if (!route_.has_value() || arrived() || phase_ == msg::RoutePhase::failed) return;
  if (phase == phase_ && reason == reason_) return;
  phase_ = phase;
  reason_ = reason;
  touch(now);
}

void RouteTask::set_progress(std::uint32_t at, std::uint32_t freed, SteadyTime now) {
  if (!route_.has_value() || (at <= at_ && freed <= freed_)) return;
  at_ = std::max(at, at_);
  freed_ = std::max(freed, freed_);
  touch(now);
}

std::optional<msg::RouteProgress> RouteTask::due(SteadyTime now) {
  if (!route_.has_value() || now < report_at_) return std::nullopt;
  reported_at_ = now;
  report_at_ = now + kRepeat;
  msg::RouteProgress progress;
  progress.goal = route_->goal;
  progress.route = route_->id;
  progress.version = route_->version;
  progress.phase = phase_;
  progress.at = at_;
  progress.freed = freed_;
  progress.released = route_->released;
  progress.goal_from_robot = goal_from_robot_;
  progress.reason = reason_;
  return progress;
}

std::optional<SteadyTime> RouteTask::next() const {
  if (!route_.has_value()) return std::nullopt;
  return report_at_;
}

}  // namespace weft::agents
