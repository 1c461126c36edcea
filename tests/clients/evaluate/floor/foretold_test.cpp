#include "clients/evaluate/floor/foretold.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "clients/evaluate/floor/foretold_study.hpp"
#include "tests/clients/evaluate/floor/small_hall.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

using agents::Floor;

TEST(ForetoldAgreement, CountsAllAndEachMetre) {
  const Agreement none = agreement_of({});
  EXPECT_EQ(none.places, 0U);
  const Agreement some = agreement_of({{0.1, true, true}, {0.5, true, false}, {1.2, false, true}, {1.3, true, true}});
  EXPECT_EQ(some.places, 4U);
  EXPECT_DOUBLE_EQ(some.foretold, 0.75);
  EXPECT_DOUBLE_EQ(some.found, 0.75);
  EXPECT_DOUBLE_EQ(some.metre_apart, 0.5);
}

class Foretelling : public testing::Test {
 protected:
  /// Returns the agreement on a way of 3 m on epoxy of that contrast, by condition.
  std::array<Agreement, Floor::conditions.size()> of_contrast(double contrast) const {
    Stage stage;
    stage.site = *agents::sim::parse_site(small_hall(12.0, 6.0, 3.0), "small");
    stage.site.floor.contrast = contrast;
    stage.line = {{2.0, 3.0}, {5.0, 3.0}};
    stage.scratch = folder.path() / "truth.now";
    stage.asked_to_stop = [] { return false; };
    const auto scenario = Scenario::make(stage, "epoxy", 1);
    Taught taught;
    if (!scenario || !teach(scenario->first(), scenario->line(), taught)) throw std::runtime_error("not taught");
    std::array<Agreement, Floor::conditions.size()> all;
    for (const Floor::Condition condition : {Floor::as_is, Floor::half_light, Floor::worn}) {
      const auto compared = compare(*scenario, condition, taught, agents::StitchConfig{});
      if (!compared || !*compared) throw std::runtime_error("not compared");
      all[condition] = agreement_of(**compared);
    }
    return all;
  }

  ForetoldOptions two_metres_on(const std::string& kind) const {
    ForetoldOptions options;
    options.site = folder.path() / "small.toml";
    options.along = folder.path() / "small.line";
    options.out = folder.path() / "out";
    options.kind = kind;
    options.metres = 2.0;
    std::ofstream(options.site) << small_hall(12.0, 6.0, 3.0);
    std::ofstream(options.along) << "2 3\n4.5 3\n";
    return options;
  }

  storage::TemporaryDirectory folder;
};

/// Tests near the limit: a tenth of the contrast lies between floors that are lost in half the light and others.
TEST_F(Foretelling, IsWhatAnotherRobotFinds) {
  constexpr double kMost = 0.65;
  constexpr double kFew = 0.35;
  const auto faint = of_contrast(0.5);
  const auto plain = of_contrast(0.8);
  const auto as_is = Floor::as_is;
  const auto half = Floor::half_light;
  for (const Agreement& agreement : faint) EXPECT_GE(agreement.places, 10U);
  EXPECT_GT(faint[as_is].foretold, kMost);
  EXPECT_GT(faint[as_is].found, kMost);
  EXPECT_LT(faint[half].foretold, kFew);
  EXPECT_LT(faint[half].found, kFew);
  EXPECT_GT(plain[half].foretold, kMost);
  EXPECT_GT(plain[half].found, kMost);
  constexpr double kMostPromised = 0.25;
  for (const auto& all : {faint, plain})
    for (const Agreement& agreement : all) EXPECT_LE(agreement.foretold, agreement.found + kMostPromised);
}

TEST_F(Foretelling, AFloorThatThereIsNotIsRefused) {
  std::ostringstream out;
  std::ostringstream progress;
  const ForetoldOptions options = two_metres_on("cheese");
  const auto refused = study_foretold(options, {out, progress, [] { return 0.0; }, [] { return false; }});
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("cheese"), std::string::npos);
}

TEST_F(Foretelling, StopsWhenAsked) {
  std::ostringstream out;
  std::ostringstream progress;
  const ForetoldOptions options = two_metres_on("epoxy");
  int samples = 5;
  const auto ended =
      study_foretold(options, {out, progress, [] { return 0.0; }, [&samples] { return --samples < 0; }});
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::stopped);
  EXPECT_FALSE(std::filesystem::exists(options.out / "truth.now"));
}

}  // namespace
}  // namespace weft::evaluate::floor
