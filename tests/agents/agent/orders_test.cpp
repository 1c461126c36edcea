#include <gtest/gtest.h>

#include <map>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

/// Arranges a localised robot that has the whole map of a ten-place route.
struct Driving : Rig {
  Driving() : laid(lay_out(70, 10)) {
    script->estimate = Estimate{{laid, 0}, Relation{}, 0.0};
    tell(server.hello());
    run(4s);
  }
  void drive() {
    script->answer.following = Following::driving;
    script->answer.command = {0.5, 0.0};
  }
  ExperienceId laid;
};

TEST(Orders, AWishForAnExposureGoesToTheBodyOnce) {
  Driving rig;
  rig.script->answer.exposes = ExposureWish{"forward", {0.004, 2.0}};
  const AgentOutput stepped = rig.agent->step(rig.sample, rig.now);
  ASSERT_TRUE(stepped.exposes.has_value());
  EXPECT_EQ(stepped.exposes->sensor, "forward");
  EXPECT_EQ(stepped.exposes->exposure.gain, 2.0);
  EXPECT_FALSE(rig.agent->tick(rig.now).exposes.has_value());
  rig.script->answer.exposes.reset();
  EXPECT_FALSE(rig.agent->step(rig.sample, rig.now).exposes.has_value());
}

TEST(Orders, RouteIsFollowedAndReported) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.script->answer.route_at = 3;
  rig.script->answer.route_freed = 2;
  rig.run(1s);
  ASSERT_EQ(rig.script->followed.size(), 1U);
  const auto progress = rig.last<msg::RouteProgress>();
  EXPECT_EQ(progress->phase, msg::RoutePhase::driving);
  EXPECT_EQ(progress->at, 3U);
  EXPECT_EQ(progress->freed, 2U);
  EXPECT_EQ(progress->released, 9U);
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::driving);
  EXPECT_EQ(rig.seen.command.linear_m_s, 0.5);
}

TEST(Orders, ReportsAreAtMostFiveASecondAndGoOnWithoutChange) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  rig.log.clear();
  for (std::uint32_t at = 1; at < 9; ++at) {
    rig.script->answer.route_at = at;
    rig.run(100ms);
  }
  EXPECT_LE(rig.sent<msg::RouteProgress>().size(), 5U);
  rig.log.clear();
  rig.run(10s);
  EXPECT_GE(rig.sent<msg::RouteProgress>().size(), 4U);
  EXPECT_LE(rig.sent<msg::RouteProgress>().size(), 6U);
}

TEST(Orders, RepeatsAreHarmlessOldVersionsIgnoredReleasesNeverTakenBack) {
  Driving rig;
  Route route = a_route(rig.laid, 10, 1);
  route.version = 2;
  route.released = 5;
  rig.tell(rig.order(route));
  rig.run(1s);
  rig.tell(rig.order(route));
  route.released = 7;
  rig.tell(rig.order(route));
  route.released = 4;
  rig.tell(rig.order(route));
  route.version = 1;
  route.released = 9;
  rig.tell(rig.order(route));
  rig.run(1s);
  EXPECT_EQ(rig.agent->route()->version, 2U);
  EXPECT_EQ(rig.agent->route()->released, 7U);
  ASSERT_EQ(rig.script->followed.size(), 2U);
  EXPECT_EQ(rig.script->followed.back().released, 7U);
}

TEST(Orders, AGoalThatIsGivenUpFails) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  rig.script->answer.following = Following::failed;
  rig.script->answer.command = {};
  rig.script->answer.reason = "goal_not_reached";
  rig.run(1s);
  const auto progress = rig.last<msg::RouteProgress>();
  EXPECT_EQ(progress->phase, msg::RoutePhase::failed);
  EXPECT_EQ(progress->reason, "goal_not_reached");
}

TEST(Orders, ArrivalIsRepeatedUntilTheServerForgetsTheRoute) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.run(1s);
  rig.script->estimate = Estimate{{rig.laid, 8}, Metric2{Pose2{0.98, 0.01, 0.02}, Eigen::Matrix3d::Zero()}, 0.0};
  rig.script->answer.following = Following::arrived;
  rig.run(300ms);
  rig.script->answer.following = Following::none;
  rig.log.clear();
  rig.run(10s);
  const auto reports = rig.sent<msg::RouteProgress>();
  ASSERT_GE(reports.size(), 4U);
  EXPECT_EQ(reports.back().phase, msg::RoutePhase::arrived);
  const Pose2 goal_from_robot = planar(reports.back().goal_from_robot);
  EXPECT_NEAR(goal_from_robot.x, -0.02, 1e-9);
  EXPECT_NEAR(goal_from_robot.y, 0.01, 1e-9);
  Route over = a_route(rig.laid, 10, 1);
  over.ended = true;
  rig.tell(rig.order(over));
  rig.run(200ms);
  rig.log.clear();
  rig.run(10s);
  EXPECT_TRUE(rig.sent<msg::RouteProgress>().empty());
  EXPECT_FALSE(rig.last<msg::RobotState>()->route);
  over.ended = false;
  rig.tell(rig.order(over));
  EXPECT_FALSE(rig.agent->route().has_value()) << "a route that is over does not come back";
}

TEST(Orders, EndedRouteStops) {
  Driving rig;
  Route route = a_route(rig.laid, 10, 1);
  rig.tell(rig.order(route));
  rig.drive();
  rig.run(1s);
  const int before = rig.script->stops;
  route.ended = true;
  rig.tell(rig.order(route));
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.script->stops, before + 1);
}

TEST(Orders, StopKeepsTheRouteAndResumeDrivesIt) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  rig.tell(rig.command(Kind::stop, 1));
  EXPECT_EQ(rig.seen.command, Twist{});
  rig.run(5s);
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_TRUE(rig.agent->route().has_value());
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::stopped);
  EXPECT_EQ(rig.last<msg::RouteProgress>()->phase, msg::RoutePhase::stopped);
  EXPECT_EQ(rig.script->followed.size(), 1U);
  rig.tell(rig.command(Kind::resume, 2));
  rig.run(1s);
  EXPECT_EQ(rig.script->followed.size(), 2U);
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::driving);
  EXPECT_EQ(rig.seen.command.linear_m_s, 0.5);
}

TEST(Orders, CommandsAreDoneOnceAndAnsweredAlways) {
  Driving rig;
  rig.tell(rig.command(Kind::stop, 7));
  rig.tell(rig.command(Kind::resume, 8));
  const int stops = rig.script->stops;
  rig.tell(rig.command(Kind::stop, 7));
  EXPECT_EQ(rig.script->stops, stops);
  const auto replies = rig.sent<msg::AgentReply>();
  ASSERT_EQ(replies.size(), 3U);
  EXPECT_EQ(replies.back().command, 7U);
  EXPECT_TRUE(replies.back().done);
  rig.run(500ms);
  EXPECT_NE(rig.last<msg::RobotState>()->mode, msg::RobotMode::stopped);
}

TEST(Orders, LostRobotStands) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  rig.script->answer.lost = true;
  rig.script->answer.reason = "blind for 1.2 m";
  rig.run(2s);
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::lost);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "blind for 1.2 m");
  EXPECT_FALSE(rig.last<msg::RobotState>()->localised);
  rig.script->answer.lost = false;
  rig.run(2s);
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::driving);
}

TEST(Orders, RestartedAgentForgetsTheRouteSaysSoAndTakesItAgain) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  EXPECT_TRUE(rig.last<msg::RobotState>()->route);
  rig.restart_agent();
  rig.run(1s);
  EXPECT_FALSE(rig.last<msg::RobotState>()->route);
  EXPECT_EQ(rig.last<msg::RobotState>()->header.incarnation, 2U);
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.run(1s);
  EXPECT_TRUE(rig.script->followed.empty()) << "it does not know where it is";
  EXPECT_FALSE(rig.script->sought.empty());
  rig.script->estimate = Estimate{{rig.laid, 2}, Relation{}, 0.0};
  rig.run(1s);
  EXPECT_EQ(rig.script->followed.size(), 1U);
}

TEST(Orders, BodyThatBreaksDownStandsAndFailsItsRoute) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  rig.body = false;
  rig.take(rig.agent->body_failed(Error{ErrorCode::unavailable, "camera unplugged"}, rig.now));
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::faulted);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "camera unplugged");
  EXPECT_EQ(rig.last<msg::RouteProgress>()->phase, msg::RoutePhase::failed);
}

TEST(Orders, WhoseProcessIsEndedStandsAndSaysThatItIsOff) {
  Driving rig;
  rig.tell(rig.order(a_route(rig.laid, 10, 1)));
  rig.drive();
  rig.run(1s);
  rig.take(rig.agent->leave(rig.now));
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::off);
}

TEST(Orders, LocaliseAnswersOnceFound) {
  Driving rig;
  rig.script->estimate.reset();
  msg::AgentCommand command = rig.command(Kind::localise, 3);
  command.seed = PlaceId{rig.laid, 4};
  rig.tell(command);
  rig.run(2s);
  ASSERT_FALSE(rig.script->sought.empty());
  EXPECT_EQ(rig.script->sought.back(), (PlaceId{rig.laid, 4}));
  EXPECT_TRUE(rig.sent<msg::AgentReply>().empty());
  rig.script->answer.fix = Fix{{rig.laid, 5}, Relation{}, {}};
  rig.run(1s);
  const auto reply = rig.last<msg::AgentReply>();
  ASSERT_TRUE(reply.has_value());
  EXPECT_TRUE(reply->done);
  EXPECT_EQ(reply->place, (PlaceId{rig.laid, 5}));
  EXPECT_FALSE(rig.seen.fixes.empty());
}

TEST(Orders, ARobotThatHasSunkAgainstItsPlacesSaysSoAndGoesOn) {
  Driving rig;
  rig.script->answer.fix = Fix{{rig.laid, 5}, Relation{}, {}};
  rig.script->answer.fix->evidence.diagnostics = {{"height_offset_m", -0.011, 0.001, 0.007}};
  rig.run(5s);
  const auto state = rig.last<msg::RobotState>();
  ASSERT_TRUE(state.has_value());
  EXPECT_NE(state->mode, msg::RobotMode::faulted);
  EXPECT_NE(state->reason.find("its camera stands 11 mm lower"), std::string::npos) << state->reason;
}

TEST(Orders, AReportThatItCannotMakeIsRefusedInWords) {
  Driving rig;
  rig.tell(rig.command(Kind::teach_report, 4));
  rig.run(1s);
  const auto reply = rig.last<msg::AgentReply>();
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->command, 4U);
  EXPECT_FALSE(reply->done);
  EXPECT_NE(reply->reason.find("nothing has been taught"), std::string::npos);
}

TEST(Orders, WhatItFoundAndRefusedIsCountedByReasonAndTold) {
  Driving rig;
  rig.script->answer.fix = Fix{{rig.laid, 5}, Relation{}, {}};
  rig.script->answer.refusals = {{"few_matches"}, {"few_matches"}, {"no_consensus"}};
  std::uint64_t asked = 10;
  const auto counted = [&] {
    rig.tell(rig.command(Kind::counts, ++asked));
    const auto reply = rig.last<msg::AgentReply>();
    EXPECT_TRUE(reply.has_value() && reply->done);
    return std::map<std::string, std::uint64_t>(reply->counts.begin(), reply->counts.end());
  };
  auto before = counted();
  rig.run(1s);
  auto after = counted();
  const std::uint64_t steps = after["navigation: fixes"] - before["navigation: fixes"];
  EXPECT_GT(steps, 0U);
  EXPECT_EQ(after["navigation: few_matches"] - before["navigation: few_matches"], 2 * steps);
  EXPECT_EQ(after["navigation: no_consensus"] - before["navigation: no_consensus"], steps);
}

TEST(Orders, LocaliseInVainSaysWhatToDo) {
  Driving rig;
  rig.script->estimate.reset();
  rig.tell(rig.command(Kind::localise, 3));
  rig.run(90s);
  const auto reply = rig.last<msg::AgentReply>();
  ASSERT_TRUE(reply.has_value());
  EXPECT_FALSE(reply->done);
  EXPECT_NE(reply->reason.find("--at LABEL"), std::string::npos);
}

TEST(Orders, RouteWaitsForItsMap) {
  Driving rig;
  const ExperienceId far = rig.lay_out(71, 8);
  rig.lost_down = [](const msg::Message& message) { return std::holds_alternative<msg::Chunk>(message); };
  rig.tell(rig.order(a_route(far, 8, 1)));
  rig.run(5s);
  EXPECT_TRUE(rig.script->followed.empty());
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::waiting);
  EXPECT_NE(rig.last<msg::RobotState>()->reason.find("map of its route"), std::string::npos);
  rig.lost_down = [](const msg::Message&) { return false; };
  rig.run(8s);
  EXPECT_EQ(rig.script->followed.size(), 1U);
}

}  // namespace
}  // namespace weft::agents::test
