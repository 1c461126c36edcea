#include "tests/simulation/chaos.hpp"

#include <cmath>

namespace weft::simulation {
namespace {

constexpr double kMeanBetween_s = 120.0;

}  // namespace

Chaos::Chaos(Fleet& fleet, Random random)
    : fleet_(fleet),
      random_(random),
      robot_wakes_(fleet.robots()),
      robot_back_(fleet.robots()),
      link_back_(fleet.robots()),
      spool_back_(fleet.robots()) {}

SteadyTime Chaos::soon(double mean_s) {
  return fleet_.now() + from_seconds(-mean_s * std::log(1.0 - random_.uniform()) + 1.0);
}

void Chaos::mild() {
  fleet_.set_faults({.loss = 0.01,
                     .duplication = 0.01,
                     .reordering = 0.02,
                     .delay_min = std::chrono::milliseconds(1),
                     .delay_max = std::chrono::milliseconds(20)});
}

void Chaos::full() {
  fleet_.set_faults({.loss = 0.03,
                     .duplication = 0.02,
                     .reordering = 0.05,
                     .delay_min = std::chrono::milliseconds(1),
                     .delay_max = std::chrono::milliseconds(200),
                     .bytes_per_second = 4U << 20U});
  on_ = true;
  next_ = soon(kMeanBetween_s);
}

void Chaos::begin(Kind kind) {
  ++played_;
  const std::size_t robot = random_.below(fleet_.robots());
  switch (kind) {
    case Kind::crash_server:
      if (!fleet_.server_up()) return;
      fleet_.crash_server();
      server_back_ = soon(15.0);
      return;
    case Kind::disk_full:
      fleet_.disk().faults.full = true;
      disk_back_ = soon(30.0);
      return;
    case Kind::writes_fail:
      fleet_.disk().faults.fail_next = static_cast<std::uint32_t>(1 + random_.below(5));
      fleet_.disk().faults.fail_with = random_.chance(0.5) ? ErrorCode::unavailable : ErrorCode::exhausted;
      return;
    case Kind::torn_write:
      fleet_.disk().faults.tear_next = true;
      return;
    case Kind::hang_server:
      fleet_.hang_server(true);
      server_wakes_ = soon(10.0);
      return;
    case Kind::stray_server:
      fleet_.stray_server(true);
      stray_gone_ = soon(1.0);
      return;
    case Kind::move_server:
      fleet_.move_server();
      return;
    default:
      begin_at(robot, kind);
  }
}

void Chaos::begin_at(std::size_t robot, Kind kind) {
  switch (kind) {
    case Kind::crash_robot:
      if (!fleet_.robot_up(robot)) return;
      fleet_.crash_robot(robot);
      robot_back_[robot] = soon(15.0);
      return;
    case Kind::cut_robot:
      fleet_.partition(robot, bus::Cut::all);
      link_back_[robot] = soon(25.0);
      return;
    case Kind::cut_one_way:
      fleet_.partition(robot, random_.chance(0.5) ? bus::Cut::sent : bus::Cut::received);
      link_back_[robot] = soon(25.0);
      return;
    case Kind::hang_robot:
      fleet_.hang_robot(robot, true);
      robot_wakes_[robot] = soon(10.0);
      return;
    case Kind::robot_disk_full:
      fleet_.spool_disk(robot).faults.full = true;
      spool_back_[robot] = soon(60.0);
      return;
    case Kind::move_robot:
      fleet_.move_robot(robot);
      return;
    default:
      return;
  }
}

void Chaos::heal_due() {
  const auto due = [&](std::optional<SteadyTime>& at) {
    const bool now = at && fleet_.now() >= *at;
    if (now) at.reset();
    return now;
  };
  if (due(disk_back_)) fleet_.disk().faults.full = false;
  if (due(server_back_)) {
    fleet_.start_server();
    if (!fleet_.server_up()) server_back_ = soon(5.0);
  }
  if (due(server_wakes_)) fleet_.hang_server(false);
  if (due(stray_gone_)) fleet_.stray_server(false);
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
    if (due(robot_wakes_[robot])) fleet_.hang_robot(robot, false);
    if (due(spool_back_[robot])) fleet_.spool_disk(robot).faults.full = false;
    if (due(robot_back_[robot])) {
      fleet_.start_robot(robot);
      if (!fleet_.robot_up(robot)) robot_back_[robot] = soon(5.0);
    }
    if (due(link_back_[robot])) fleet_.partition(robot, bus::Cut::none);
  }
}

void Chaos::play() {
  heal_due();
  if (!on_ || fleet_.now() < next_) return;
  next_ = soon(kMeanBetween_s);
  begin(draw());
  if (random_.chance(0.2)) begin(draw());
}

void Chaos::over() {
  on_ = false;
  fleet_.set_faults({.delay_min = std::chrono::milliseconds(1), .delay_max = std::chrono::milliseconds(5)});
  fleet_.disk().faults = {};
  fleet_.hang_server(false);
  fleet_.stray_server(false);
  if (!fleet_.server_up()) fleet_.start_server();
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
    fleet_.partition(robot, bus::Cut::none);
    fleet_.spool_disk(robot).faults = {};
    fleet_.hang_robot(robot, false);
    if (!fleet_.robot_up(robot)) fleet_.start_robot(robot);
  }
  server_back_.reset();
  disk_back_.reset();
  server_wakes_.reset();
  stray_gone_.reset();
  robot_wakes_.assign(fleet_.robots(), std::nullopt);
  robot_back_.assign(fleet_.robots(), std::nullopt);
  link_back_.assign(fleet_.robots(), std::nullopt);
  spool_back_.assign(fleet_.robots(), std::nullopt);
}

}  // namespace weft::simulation
