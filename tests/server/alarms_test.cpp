#include "server/queries/alarms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "server/queries/alarm_watch.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = msg::AlarmKind;

const WallTime kNow{5000s};

msg::MapInfo well() {
  msg::MapInfo info;
  info.disk_free_bytes = msg::kDiskLowBytes;
  return info;
}

msg::RobotRow robot(std::uint8_t number) {
  msg::RobotRow row;
  row.description.header.sender.bytes.fill(number);
  row.description.name = "r" + std::to_string(number);
  row.is_heard = true;
  row.state.place = {ExperienceId{1}, number};
  return row;
}

std::vector<Kind> kinds(const std::vector<msg::Alarm>& alarms) {
  std::vector<Kind> found;
  for (const msg::Alarm& alarm : alarms) found.push_back(alarm.kind);
  return found;
}

TEST(AlarmsOf, AFleetThatIsWellHasNone) {
  EXPECT_THAT(alarms_of(well(), {robot(1), robot(2)}, kNow), IsEmpty());
}

TEST(AlarmsOf, TheServersOwn) {
  msg::MapInfo info = well();
  info.disk_free_bytes = msg::kDiskLowBytes / 4;
  info.stopped = "the disk is full";
  info.unjoined = "nothing joins r1 and r2";
  const std::vector<msg::Alarm> alarms = alarms_of(info, {}, kNow);
  ASSERT_THAT(kinds(alarms), ElementsAre(Kind::store, Kind::disk, Kind::unjoined));
  EXPECT_EQ(alarms[0].detail, "the disk is full");
  EXPECT_EQ(alarms[1].detail, "0.25 GiB free");
  EXPECT_EQ(alarms[2].about, "server");
}

TEST(AlarmsOf, WhatARobotSaysOfItself) {
  msg::RobotRow row = robot(3);
  row.state.mode = msg::RobotMode::lost;
  row.state.reason = "no fix for 3 m";
  row.state.spool_refuses = "no space left";
  row.clock_skew_s = -3.0;
  row.state.safety = Safety::emergency_stop;
  row.is_deaf = true;
  row.state.server_unheard_s = 13.0;
  const std::vector<msg::Alarm> alarms = alarms_of(well(), {row}, kNow);
  ASSERT_THAT(kinds(alarms), ElementsAre(Kind::lost, Kind::safety_stop, Kind::spool, Kind::deaf, Kind::clock));
  EXPECT_EQ(alarms[0].detail, "no fix for 3 m");
  EXPECT_EQ(alarms[0].about, "r3");
  EXPECT_EQ(alarms[0].place, row.state.place);
  EXPECT_EQ(alarms[3].detail, "it has heard nothing of the server for 13 s");
  EXPECT_EQ(alarms[4].detail, "3000 ms behind the server's clock");
  row = robot(3);
  row.state.mode = msg::RobotMode::faulted;
  row.state.safety = Safety::blocked;
  EXPECT_THAT(kinds(alarms_of(well(), {row}, kNow)), ElementsAre(Kind::faulted, Kind::blocked));
  row = robot(3);
  row.clock_skew_s = msg::kClockOff_s;
  row.state.safety = Safety::speed_limited;
  EXPECT_THAT(alarms_of(well(), {row}, kNow), IsEmpty());
}

TEST(AlarmsOf, OfASilentRobotItsLastWordDoesNotCount) {
  msg::RobotRow row = robot(1);
  row.is_heard = false;
  row.silent_s = 40.0;
  row.state.mode = msg::RobotMode::lost;
  const std::vector<msg::Alarm> alarms = alarms_of(well(), {row}, kNow);
  ASSERT_THAT(kinds(alarms), ElementsAre(Kind::silent));
  EXPECT_EQ(alarms[0].since, kNow - 40s);
  row.state.mode = msg::RobotMode::off;
  EXPECT_THAT(alarms_of(well(), {row}, kNow), IsEmpty()) << "its agent was ended";
}

TEST(AlarmsOf, TwinsAndStandstillsOnceEach) {
  std::vector<msg::RobotRow> rows = {robot(1), robot(2), robot(3)};
  rows[0].is_twin = true;
  for (std::size_t i = 0; i < 2; ++i) {
    rows[i].standstill = "r1 and r2 wait for one another";
    rows[i].wait.at = {ExperienceId{1}, 9};
    rows[i].wait.since = WallTime{(4900s) - std::chrono::seconds(i)};
  }
  const std::vector<msg::Alarm> alarms = alarms_of(well(), rows, kNow);
  ASSERT_THAT(kinds(alarms), ElementsAre(Kind::twins, Kind::standstill));
  EXPECT_EQ(alarms[1].since, WallTime{4899s}) << "of who waits longest";
  EXPECT_EQ(alarms[1].detail, "r1 and r2 wait for one another");
}

Now at(Duration after) {
  return {.steady = SteadyTime{100s} + after, .wall = kNow + after};
}

TEST(AlarmWatch, RemembersSinceWhenAndForgetsWhatHasEnded) {
  AlarmWatch watch;
  msg::RobotRow row = robot(1);
  row.state.mode = msg::RobotMode::lost;
  const auto look = [&](Duration after) { return watch.seen(alarms_of(well(), {row}, kNow + after), {}, at(after)); };
  EXPECT_EQ(look(0s).front().since, kNow);
  EXPECT_EQ(look(30s).front().since, kNow);
  row.state.mode = msg::RobotMode::idle;
  EXPECT_THAT(look(40s), IsEmpty());
  row.state.mode = msg::RobotMode::lost;
  EXPECT_EQ(look(50s).front().since, kNow + 50s);
}

TEST(AlarmWatch, RefusedMessagesAreAnAlarmForAWhile) {
  AlarmWatch watch;
  Counters counters = {{"weft/1/query: Query.kind must be from 1 to 10", 2}, {"bus: not sent, exhausted", 5}};
  const auto look = [&](Duration after) { return watch.seen({}, counters, at(after)); };
  ASSERT_THAT(kinds(look(0s)), ElementsAre(Kind::refused));
  EXPECT_THAT(look(5s).front().detail, HasSubstr("2 refused, the last 5 s ago: weft/1/query"));
  counters["intake: batch refused, conflict"] = 1;
  EXPECT_THAT(look(60s).front().detail, HasSubstr("3 refused, the last 0 s ago: intake"));
  EXPECT_EQ(look(msg::kRefusedLately).front().since, kNow);
  EXPECT_THAT(look(60s + msg::kRefusedLately), IsEmpty());
  counters["bus: not sent, exhausted"] = 50;
  EXPECT_THAT(look(70s + msg::kRefusedLately), IsEmpty()) << "that is no refused message";
}

}  // namespace
}  // namespace weft::server
