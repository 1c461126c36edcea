#include "server/eta/speeds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/eta/arrivals.hpp"
#include "server/eta/passing.hpp"

/// Tests what is learned of the times that robots take.
namespace weft::server {
namespace {

using namespace std::chrono_literals;
using testing::SizeIs;
using Phase = msg::RoutePhase;

constexpr ExperienceId kRun{0x11};
constexpr RunPiece kFirst{kRun, 0, true};

/// Returns a route over the places of a run, half a metre apart.
Route route_over(std::uint32_t places) {
  Route route;
  for (std::uint32_t i = 0; i < places; ++i) {
    route.places.push_back({kRun, i});
    if (i > 0) route.relations.emplace_back(Metric2{{0.5, 0.0, 0.0}, Eigen::Matrix3d::Identity()});
  }
  return route;
}

TEST(Speeds, AreGuessedBeforeAnythingWasLearned) {
  EXPECT_DOUBLE_EQ(Speeds().left(route_over(41), 0).total_s(), 20.0 / Speeds::kDefaultSpeed_m_s);
}

TEST(Speeds, AreTheMedianOfTheLatestPasses) {
  Speeds speeds;
  for (int i = 0; i < 30; ++i) speeds.add(kFirst, {8.0, 8.0, 0.0});
  for (int i = 0; i < 11; ++i) speeds.add(kFirst, {8.0, 40.0, 0.0});
  EXPECT_DOUBLE_EQ(speeds.pace(kFirst).speed_m_s, 0.2) << "11 of the latest 20";
  for (int i = 0; i < 12; ++i) speeds.add(kFirst, {8.0, 8.0, 0.0});
  EXPECT_DOUBLE_EQ(speeds.pace(kFirst).speed_m_s, 1.0);
}

TEST(Speeds, OfAPieceThatNobodyDroveAreThoseOfAllPieces) {
  Speeds speeds;
  speeds.add(kFirst, {8.0, 32.0, 4.0});
  const Pace other = speeds.pace({kRun, 7, false});
  EXPECT_DOUBLE_EQ(other.speed_m_s, 0.25);
  EXPECT_DOUBLE_EQ(other.wait_s_per_m, 0.5);
}

TEST(Speeds, ShortPassesCountTogether) {
  Speeds speeds;
  for (int i = 0; i < 4; ++i) speeds.add(kFirst, {0.5, 5.0, 0.0});
  EXPECT_DOUBLE_EQ(speeds.pace(kFirst).speed_m_s, 0.1);
  EXPECT_THAT(speeds.take_unsaved(10).at(0).passes, SizeIs(1));
}

TEST(Speeds, WaitsCountWithThoseOfAllPiecesUntilThereIsEnough) {
  Speeds speeds;
  speeds.add(kFirst, {10.0, 20.0, 30.0});
  speeds.add({kRun, 1, true}, {30.0, 60.0, 10.0});
  EXPECT_DOUBLE_EQ(speeds.pace(kFirst).wait_s_per_m, (30.0 + 20.0) / (10.0 + 20.0)) << "a second a metre of all";
  const TimeLeft left = speeds.left(route_over(17), 0);
  EXPECT_DOUBLE_EQ(left.drive_s, 16.0);
  EXPECT_DOUBLE_EQ(left.wait_s, 8.0 * 50.0 / 30.0);
}

TEST(Speeds, AreNoHigherThanALimit) {
  Speeds speeds;
  speeds.add(kFirst, {8.0, 8.0, 0.0});
  Route route = route_over(17);
  route.limits = {{4, 8, 0.25}};
  EXPECT_DOUBLE_EQ(speeds.left(route, 0).drive_s, 5.5 + 2.5 / 0.25) << "five hops begin at places of the limit";
  EXPECT_DOUBLE_EQ(speeds.left(route, 10).drive_s, 3.0);
}

TEST(Speeds, AreStoredOnceEach) {
  Speeds speeds;
  for (std::uint32_t piece = 0; piece < 5; ++piece) speeds.add({kRun, piece, true}, {8.0, 16.0, 0.0});
  const auto three = speeds.take_unsaved(3);
  EXPECT_THAT(three, SizeIs(3));
  EXPECT_THAT(speeds.take_unsaved(10), SizeIs(2));
  EXPECT_FALSE(speeds.has_unsaved());
  speeds.put_back(three);
  EXPECT_THAT(speeds.take_unsaved(10), SizeIs(3)) << "they could not be stored";
  std::map<RunPiece, std::vector<Pass>> stored;
  for (const storage::PutPasses& put : three) stored[put.piece] = put.passes;
  EXPECT_DOUBLE_EQ(Speeds(stored).pace(kFirst).speed_m_s, 0.5);
  EXPECT_FALSE(Speeds(stored).has_unsaved());
}

/// Arranges a robot that reports on a route of twenty metres.
struct PassingOfARobot : testing::Test {
  void report(std::uint32_t at, Phase phase, Duration after) {
    now += after;
    passing.on_report(route, at, phase, now, speeds);
  }
  Route route = route_over(41);
  SteadyTime now{1000s};
  Speeds speeds;
  Passing passing;
};

TEST_F(PassingOfARobot, TellsDrivingFromWaiting) {
  report(0, Phase::driving, 0s);
  for (std::uint32_t at = 1; at <= 8; ++at) report(at, Phase::driving, 2s);
  report(8, Phase::waiting, 1s);
  for (int i = 0; i < 6; ++i) report(8, Phase::waiting, 2s);
  report(8, Phase::driving, 1s);
  for (std::uint32_t at = 9; at <= 16; ++at) report(at, Phase::driving, 2s);
  report(17, Phase::driving, 2s);
  const auto learned = speeds.take_unsaved(10);
  ASSERT_THAT(learned, SizeIs(1)) << "it is in the second piece";
  EXPECT_EQ(learned[0].piece, kFirst);
  EXPECT_EQ(learned[0].passes, (std::vector<Pass>{{8.0, 33.0, 13.0}}));
}

TEST_F(PassingOfARobot, SharesTheTimeBetweenReportsByLength) {
  report(10, Phase::driving, 0s);
  report(20, Phase::driving, 5s);
  report(40, Phase::arrived, 10s);
  const auto learned = speeds.take_unsaved(10);
  ASSERT_THAT(learned, SizeIs(3));
  EXPECT_EQ(learned[0].passes, (std::vector<Pass>{{3.0, 3.0, 0.0}}));
  EXPECT_EQ(learned[1].passes, (std::vector<Pass>{{8.0, 8.0, 0.0}}));
  EXPECT_EQ(learned[2].passes, (std::vector<Pass>{{4.0, 4.0, 0.0}}));
}

TEST_F(PassingOfARobot, DrivenBackwardIsAnotherPiece) {
  std::reverse(route.places.begin(), route.places.end());
  report(0, Phase::driving, 0s);
  report(40, Phase::arrived, 20s);
  for (const storage::PutPasses& put : speeds.take_unsaved(10)) EXPECT_FALSE(put.piece.is_onward);
}

TEST_F(PassingOfARobot, GoesOnOverTheNextVersionOfItsRoute) {
  report(0, Phase::driving, 0s);
  report(4, Phase::driving, 2s);
  route.places.erase(route.places.begin(), route.places.begin() + 2);
  route.relations.resize(route.places.size() - 1);
  report(0, Phase::accepted, 1s);
  report(6, Phase::driving, 1s);
  report(22, Phase::driving, 8s);
  report(38, Phase::arrived, 8s);
  EXPECT_EQ(speeds.take_unsaved(10).at(0).passes, (std::vector<Pass>{{8.0, 8.0, 0.0}}));
}

TEST_F(PassingOfARobot, LeavesOutWhatNobodyHeard) {
  report(0, Phase::driving, 0s);
  report(4, Phase::driving, 2s);
  report(8, Phase::driving, 11s);
  report(12, Phase::stopped, 2s);
  report(12, Phase::driving, 60s);
  report(16, Phase::arrived, 2s);
  const auto learned = speeds.take_unsaved(10);
  ASSERT_THAT(learned, SizeIs(1));
  EXPECT_EQ(learned[0].passes, (std::vector<Pass>{{2.0, 2.0, 0.0}, {2.0, 2.0, 0.0}}));
}

TEST(ArrivalBand, IsWideUntilEnoughIsKnown) {
  Band band;
  for (std::size_t i = 1; i < Band::kFewest; ++i) band.add(100.0, 100.0);
  EXPECT_LE(band.soonest(), 0.5);
  EXPECT_GE(band.latest(), 2.0);
  band.add(100.0, 100.0);
  EXPECT_DOUBLE_EQ(band.soonest(), 1.0);
  EXPECT_DOUBLE_EQ(band.latest(), 1.0);
}

TEST(ArrivalBand, HoldsFourOfFive) {
  Band band;
  for (int i = 0; i <= 20; ++i) band.add(80.0 + 5.0 * i, 100.0);
  EXPECT_DOUBLE_EQ(band.soonest(), 0.9);
  EXPECT_DOUBLE_EQ(band.latest(), 1.7);
}

TEST(Arrivals, AreStoredInRoundsOfHalfAMinute) {
  Arrivals arrivals({});
  Route route = route_over(41);
  route.id.bytes[0] = 1;
  RobotId robot;
  robot.bytes[0] = 1;
  const auto drive = [&](SteadyTime now) {
    msg::RouteProgress report;
    report.phase = Phase::driving;
    arrivals.on_report(robot, route, report, now);
    report.phase = Phase::arrived;
    report.at = 40;
    arrivals.on_report(robot, route, report, now + 5s);
    arrivals.ended(robot);
  };
  drive(SteadyTime(100s));
  EXPECT_THAT(arrivals.due(SteadyTime(105s)), SizeIs(3));
  drive(SteadyTime(110s));
  EXPECT_THAT(arrivals.due(SteadyTime(134s)), SizeIs(0));
  EXPECT_THAT(arrivals.due(SteadyTime(135s)), SizeIs(3));
}

}  // namespace
}  // namespace weft::server
