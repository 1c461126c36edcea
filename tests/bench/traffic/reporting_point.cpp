#include "tests/bench/traffic/reporting_point.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "tests/bench/traffic/fleet.hpp"
#include "tests/bench/traffic/taught_lanes.hpp"

namespace weft::bench {
namespace {
constexpr double kApart_m = kCell_m / TaughtLanes::kPlacesOfCell;
}  // namespace

ReportingPoint::ReportingPoint(const RobotId& id, const PlaceId& at) : id_(id), name_(to_string(id)), at_(at) {}

std::vector<msg::Message> ReportingPoint::arrive() {
  msg::Hello hello;
  hello.peer = id_;
  hello.incarnation = 1;
  hello.role = msg::Role::agent;
  hello.name = name_;
  hello.vendor = "inprocess";
  msg::RobotDescription description;
  description.header = header();
  description.name = name_;
  description.body = "sim";
  description.methods = {"marks"};
  description.footprint_radius_m = kRadius_m;
  description.knows_limits = true;
  return {hello, description, state()};
}

void ReportingPoint::take(const msg::RouteOrder& order, SteadyTime now) {
  const std::optional<RouteId> before = task_.route() ? std::optional(task_.route()->id) : std::nullopt;
  if (task_.take(order.route, now) != agents::RouteTask::Took::renewed) return;
  const std::vector<PlaceId>& places = task_.route()->places;
  const bool is_on_it = before == order.route.id && index_ < places.size() && places[index_] == at_;
  if (is_on_it) return;
  const auto found = std::find(places.begin(), places.end(), at_);
  index_ = found == places.end() ? 0 : static_cast<std::uint32_t>(found - places.begin());
  beyond_m_ = 0.0;
}

void ReportingPoint::take(const msg::ClockProbe& probe, WallTime now) {
  answers_.emplace_back(msg::ClockReply{
      .header = header(), .probe = probe.probe, .probe_sent = probe.sent, .received = now, .replied = now});
}

std::vector<msg::Message> ReportingPoint::live(SteadyTime now) {
  drive(now);
  std::vector<msg::Message> said = std::exchange(answers_, {});
  if (std::optional<msg::RouteProgress> progress = task_.due(now)) {
    progress->header = header();
    said.emplace_back(*std::move(progress));
  }
  said.emplace_back(state());
  return said;
}

void ReportingPoint::drive(SteadyTime now) {
  drives_ = task_.route() && index_ < task_.route()->released;
  if (!task_.route()) return;
  if (drives_) beyond_m_ += kSpeed_m_s * kBetweenStates_s;
  if (beyond_m_ >= kApart_m) {
    beyond_m_ -= kApart_m;
    ++index_;
  }
  at_ = task_.route()->places[index_];
  const bool is_there = index_ + 1 == task_.route()->places.size();
  task_.set_progress(index_, index_ > 0 ? index_ - 1 : 0, now);
  task_.set(is_there  ? msg::RoutePhase::arrived
            : drives_ ? msg::RoutePhase::driving
                      : msg::RoutePhase::waiting,
            "", now);
}

msg::RobotState ReportingPoint::state() {
  msg::RobotState state;
  state.header = header();
  state.name = name_;
  state.localised = true;
  state.place = at_;
  state.speed_m_s = drives_ ? kSpeed_m_s : 0.0;
  if (!task_.route()) return state;
  state.mode = drives_ ? msg::RobotMode::driving : msg::RobotMode::waiting;
  state.goal = task_.route()->goal;
  state.route = task_.route()->id;
  state.route_version = task_.route()->version;
  return state;
}

}  // namespace weft::bench
