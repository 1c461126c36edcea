#include "agents/agent/diagnostic_watch.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <utility>

namespace weft::agents {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr ExperienceId first{1};
constexpr ExperienceId second{2};

std::string notice(double value, std::string_view compared_with) {
  return std::to_string(std::lround(1000.0 * std::abs(value))) + " mm " + (value < 0.0 ? "lower" : "higher") +
         " than " + std::string(compared_with);
}
constexpr WatchedDiagnostic kHeight{"height_m", {0.007, 0.005}, {0.005, 0.003}, notice, "well again"};

void add(DiagnosticWatch& watch, double value, int times, const ExperienceId& experience = first) {
  for (int i = 0; i < times; ++i) watch.add(experience, value + (i % 2 == 0 ? 0.001 : -0.001));
}

TEST(DiagnosticWatch, ARobotThatSinksByACentimetreIsNoticedUntilItRises) {
  DiagnosticWatch watch{kHeight};
  add(watch, -0.002, 20);  // two calibrations differ by so much
  EXPECT_THAT(watch.notice(), IsEmpty());
  add(watch, -0.012, 15);
  EXPECT_THAT(watch.notice(), HasSubstr("mm lower than its places say"));
  add(watch, -0.006, 15);
  EXPECT_THAT(watch.notice(), testing::Not(IsEmpty())) << "it does not flicker";
  add(watch, -0.002, 15);
  EXPECT_THAT(watch.notice(), IsEmpty());
}

TEST(DiagnosticWatch, AFewWrongFixesAndTooFewOfThemSayNothing) {
  DiagnosticWatch watch{kHeight};
  add(watch, 0.02, 7);
  EXPECT_FALSE(watch.value());
  EXPECT_THAT(watch.notice(), IsEmpty());
  DiagnosticWatch other{kHeight};
  add(other, 0.0, 12);
  add(other, 0.05, 3);
  EXPECT_NEAR(*other.value(), 0.001, 1e-9);
  EXPECT_THAT(other.notice(), IsEmpty());
}

TEST(DiagnosticWatch, ALoadIsNoticedThoughTwoCalibrationsHideIt) {
  DiagnosticWatch watch{kHeight};
  add(watch, 0.005, 15);
  EXPECT_THAT(watch.notice(), IsEmpty());
  add(watch, -0.005, 15);
  EXPECT_THAT(watch.notice(), HasSubstr("10 mm lower than when it came here before"));
  EXPECT_NEAR(*watch.change(), -0.010, 0.0021);
  add(watch, 0.005, 15);
  EXPECT_THAT(watch.notice(), IsEmpty());
}

TEST(DiagnosticWatch, PlacesTaughtByAnotherCameraAreNoLoad) {
  DiagnosticWatch watch{kHeight};
  add(watch, 0.004, 20, first);
  add(watch, -0.004, 20, second);
  EXPECT_THAT(watch.notice(), IsEmpty());
  add(watch, -0.004, 20, first);
  EXPECT_THAT(watch.notice(), HasSubstr("lower than when it came here before"));
}

TEST(DiagnosticWatch, HigherIsNoticedToo) {
  DiagnosticWatch watch{kHeight};
  add(watch, 0.01, 10);
  EXPECT_THAT(watch.notice(), HasSubstr("higher"));
}

Fix fix_with(std::vector<Diagnostic> diagnostics) {
  Fix fix{{first, 3}, Relation{}, {}};
  fix.evidence.diagnostics = std::move(diagnostics);
  return fix;
}

TEST(DiagnosticWatches, SayOnceWhenANoticeBeginsAndWhenItEnds) {
  DiagnosticWatches watches({kHeight});
  std::vector<std::string> notes;
  for (const double value : {0.0, -0.01, 0.0}) {
    for (int i = 0; i < 20; ++i) {
      std::string note = watches.add(fix_with({{"brightness", 9.0, 0.0, 0.0}, {"height_m", value, 0.001, 0.007}}));
      if (!note.empty()) notes.push_back(std::move(note));
    }
    EXPECT_EQ(watches.notice().empty(), value == 0.0) << watches.notice();
  }
  EXPECT_THAT(notes, testing::ElementsAre(testing::StartsWith("10 mm lower than"), "well again"));
}

TEST(DiagnosticWatches, StateWhatIsMeasuredAndTheMediansWithTheirBounds) {
  DiagnosticWatches watches({kHeight});
  const Diagnostic pitch{"mount_pitch_rad", 0.0087, 0.0006, 0.0};
  EXPECT_THAT(watches.all({pitch}), testing::ElementsAre(pitch));
  for (int i = 0; i < 8; ++i) watches.add(fix_with({{"height_m", -0.01, 0.001, 0.007}}));
  EXPECT_THAT(watches.all({pitch}), testing::ElementsAre(pitch, Diagnostic{"height_m", -0.01, 0.0, 0.007}));
}

TEST(DiagnosticWords, NameEachWithItsSigmaWhereThereIsOne) {
  EXPECT_EQ(words_of({}), "");
  EXPECT_EQ(words_of({{"mount_pitch_rad", 0.0087, 0.0006, 0.0}, {"height_offset_m", -0.0101, 0.0, 0.007}}),
            "mount_pitch_rad +0.0087 (one sigma 0.0006), height_offset_m -0.01");
}

}  // namespace
}  // namespace weft::agents
