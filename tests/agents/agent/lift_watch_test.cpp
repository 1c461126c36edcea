#include "agents/agent/lift_watch.hpp"

#include <gmock/gmock.h>

namespace weft::agents {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr ExperienceId first{1};
constexpr ExperienceId second{2};

void add(LiftWatch& watch, double lift_m, int times, const ExperienceId& experience = first) {
  for (int i = 0; i < times; ++i) watch.add(experience, lift_m + (i % 2 == 0 ? 0.001 : -0.001));
}

TEST(LiftWatch, ARobotThatSinksByACentimetreIsNoticedUntilItRises) {
  LiftWatch watch;
  add(watch, -0.002, 20);  // two calibrations differ by so much
  EXPECT_THAT(watch.notice(), IsEmpty());
  add(watch, -0.012, 15);
  EXPECT_THAT(watch.notice(), HasSubstr("mm lower than its places say"));
  add(watch, -0.006, 15);
  EXPECT_THAT(watch.notice(), testing::Not(IsEmpty())) << "it does not flicker";
  add(watch, -0.002, 15);
  EXPECT_THAT(watch.notice(), IsEmpty());
}

TEST(LiftWatch, AFewWrongFixesAndTooFewOfThemSayNothing) {
  LiftWatch watch;
  add(watch, 0.02, 7);
  EXPECT_FALSE(watch.lift_m());
  EXPECT_THAT(watch.notice(), IsEmpty());
  LiftWatch other;
  add(other, 0.0, 12);
  add(other, 0.05, 3);
  EXPECT_NEAR(*other.lift_m(), 0.001, 1e-9);
  EXPECT_THAT(other.notice(), IsEmpty());
}

TEST(LiftWatch, ALoadIsNoticedThoughTwoCalibrationsHideIt) {
  LiftWatch watch;
  add(watch, 0.005, 15);
  EXPECT_THAT(watch.notice(), IsEmpty());
  add(watch, -0.005, 15);
  EXPECT_THAT(watch.notice(), HasSubstr("10 mm lower than when it came here before"));
  EXPECT_NEAR(*watch.change_m(), -0.010, 0.0021);
  add(watch, 0.005, 15);
  EXPECT_THAT(watch.notice(), IsEmpty());
}

TEST(LiftWatch, PlacesTaughtByAnotherCameraAreNoLoad) {
  LiftWatch watch;
  add(watch, 0.004, 20, first);
  add(watch, -0.004, 20, second);
  EXPECT_THAT(watch.notice(), IsEmpty());
  add(watch, -0.004, 20, first);
  EXPECT_THAT(watch.notice(), HasSubstr("lower than when it came here before"));
}

TEST(LiftWatch, HigherIsNoticedToo) {
  LiftWatch watch;
  add(watch, 0.01, 10);
  EXPECT_THAT(watch.notice(), HasSubstr("higher"));
}

TEST(MountWords, SayWhatTheHeightIsKnownFrom) {
  MountReport report;
  report.tilt.pitch_rad = 0.00873;
  EXPECT_THAT(words_of(report, std::nullopt), testing::AllOf(HasSubstr("pitch +0.50"), HasSubstr("not observable")));
  report.height_by_wheels = 0.012;
  EXPECT_THAT(words_of(report, -0.0101),
              testing::AllOf(HasSubstr("+1.2 % by the wheels"), HasSubstr("-10 mm by stored places"),
                             testing::Not(HasSubstr("not observable"))));
}

}  // namespace
}  // namespace weft::agents
