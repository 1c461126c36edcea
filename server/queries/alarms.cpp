#include "server/queries/alarms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/safety.hpp"
#include "core/text.hpp"

namespace weft::server {
namespace {

using Wrong = msg::AlarmKind;

constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;

msg::Alarm of_server(Wrong kind, std::string detail) {
  return {.kind = kind, .robot = {}, .about = "server", .place = {}, .since = {}, .detail = std::move(detail)};
}

msg::Alarm of_robot(Wrong kind, const msg::RobotRow& row, std::string detail) {
  return {.kind = kind,
          .robot = row.description.header.sender,
          .about = row.description.name,
          .place = row.state.place,
          .since = {},
          .detail = std::move(detail)};
}

void add_server(const msg::MapInfo& info, std::vector<msg::Alarm>& alarms) {
  if (!info.stopped.empty()) alarms.push_back(of_server(Wrong::store, info.stopped));
  if (info.disk_free_bytes < msg::kDiskLowBytes) {
    const double free = static_cast<double>(info.disk_free_bytes) / kGiB;
    alarms.push_back(of_server(Wrong::disk, fixed_number(free, 2) + " GiB free"));
  }
  if (!info.unjoined.empty()) alarms.push_back(of_server(Wrong::unjoined, info.unjoined));
}

void add_silent(const msg::RobotRow& row, WallTime now, std::vector<msg::Alarm>& alarms) {
  alarms.push_back(of_robot(Wrong::silent, row, "not heard for " + fixed_number(row.silent_s, 0) + " s"));
  alarms.back().since = now - from_seconds(row.silent_s);
}

/// Adds what a robot that is heard says of itself.
void add_heard(const msg::RobotRow& row, std::vector<msg::Alarm>& alarms) {
  const msg::RobotState& state = row.state;
  if (state.mode == msg::RobotMode::lost) alarms.push_back(of_robot(Wrong::lost, row, state.reason));
  if (state.mode == msg::RobotMode::faulted) alarms.push_back(of_robot(Wrong::faulted, row, state.reason));
  if (state.safety == Safety::blocked) alarms.push_back(of_robot(Wrong::blocked, row, state.reason));
  if (is_stop(state.safety)) alarms.push_back(of_robot(Wrong::safety_stop, row, to_string(state.safety)));
  if (!state.spool_refuses.empty()) alarms.push_back(of_robot(Wrong::spool, row, state.spool_refuses));
  if (row.is_deaf) {
    const std::string unheard = fixed_number(state.server_unheard_s, 0);
    alarms.push_back(of_robot(Wrong::deaf, row, "it has heard nothing of the server for " + unheard + " s"));
  }
  if (std::abs(row.clock_skew_s) > msg::kClockOff_s) {
    const bool is_ahead = row.clock_skew_s > 0.0;
    alarms.push_back(of_robot(Wrong::clock, row,
                              fixed_number(std::abs(row.clock_skew_s) * 1000.0, 0) + " ms " +
                                  (is_ahead ? "ahead of" : "behind") + " the server's clock"));
  }
}

void add_standstill(const msg::RobotRow& row, std::vector<msg::Alarm>& alarms) {
  if (row.standstill.empty()) return;
  const bool waits = bool(row.wait.at);
  const auto known = std::ranges::find_if(alarms, [&row](const msg::Alarm& alarm) {
    return alarm.kind == Wrong::standstill && alarm.detail == row.standstill;
  });
  if (known == alarms.end()) {
    alarms.push_back(of_robot(Wrong::standstill, row, row.standstill));
    if (waits) alarms.back().since = row.wait.since;
  } else if (waits) {
    known->since = known->since == WallTime{} ? row.wait.since : std::min(known->since, row.wait.since);
  }
}

}  // namespace

std::vector<msg::Alarm> alarms_of(const msg::MapInfo& info, const std::vector<msg::RobotRow>& robots, WallTime now) {
  std::vector<msg::Alarm> alarms;
  add_server(info, alarms);
  for (const msg::RobotRow& row : robots) {
    if (row.is_twin)
      alarms.push_back(of_robot(Wrong::twins, row, "two live agents say that they are " + row.description.name));
    const bool was_ended = row.state.mode == msg::RobotMode::off;
    if (!row.is_heard && !was_ended) add_silent(row, now, alarms);
    if (row.is_heard && !was_ended) add_heard(row, alarms);
    add_standstill(row, alarms);
  }
  return alarms;
}

bool counts_refused(const std::string& counter) {
  static constexpr std::array<std::string_view, 8> kBeginnings = {"weft/",
                                                                  "other reasons",
                                                                  "bus: message is larger",
                                                                  "bus: bytes are not",
                                                                  "hello: no protocol version in common",
                                                                  "hello of another server",
                                                                  "message that only a server sends",
                                                                  "intake: batch refused"};
  return std::ranges::any_of(kBeginnings, [&](std::string_view begin) { return counter.starts_with(begin); });
}

}  // namespace weft::server
