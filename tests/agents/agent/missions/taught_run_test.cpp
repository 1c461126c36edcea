#include "agents/agent/missions/taught_run.hpp"

#include <gtest/gtest.h>

#include "core/names.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {

TEST(TaughtRun, HasAnExperienceForEachMethod) {
  ExperienceIds ids(Random(5));
  const Result<TaughtRun> run = new_run("aisle", {"marks", "more", "most"}, ids);
  ASSERT_TRUE(run);
  ASSERT_EQ(run->others.size(), 2U);
  EXPECT_NE(run->experience, run->others[0]);
  EXPECT_NE(run->others[0], run->others[1]);
}

TEST(TaughtRun, NameIsRefusedThatIsTooLongWithAMethodAdded) {
  ExperienceIds ids(Random(5));
  const std::string name(kLongestName - 5, 'a');
  EXPECT_TRUE(new_run(name, {"longer", "four"}, ids)) << "the first method's experience has the name itself";
  const Result<TaughtRun> run = new_run(name, {"four", "longer"}, ids);
  ASSERT_FALSE(run);
  EXPECT_NE(run.error().message.find("-longer"), std::string::npos);
}

TEST(TaughtRun, OthersOfARunWithoutANameHaveNone) {
  EXPECT_EQ(name_of_other("", "floor"), "");
  EXPECT_EQ(name_of_other("aisle", "floor"), "aisle-floor");
}

TEST(TaughtRun, CountsAPlaceOnceHoweverManyEdgesJoinIt) {
  TaughtRun run;
  run.experience = ExperienceId{1};
  EXPECT_EQ(summary(run).rfind("0 places, none joined", 0), 0U);
  Kept kept;
  kept.place.id = {run.experience, 0};
  for (std::uint32_t index : {4U, 5U}) {
    kept.edges.push_back(an_edge({ExperienceId{2}, index}, kept.place.id));
    kept.edges.back().origin = Origin::stitch;
  }
  run.count(kept);
  EXPECT_EQ(summary(run), "1 place, 1 joined to what was taught before, or to its own beginning");
}

TEST(TaughtRun, PlacesWhoseStitchesWereHeldBackAreCountedWhenTheseAreHandedIn) {
  TaughtRun run;
  run.experience = ExperienceId{1};
  for (std::uint32_t index = 0; index < 3; ++index) {
    Kept kept;
    kept.place.id = {run.experience, index};
    for (std::uint32_t before = 0; index == 2 && before < 2; ++before) {
      kept.edges.push_back(an_edge({ExperienceId{2}, before}, {run.experience, before}));
      kept.edges.back().origin = Origin::stitch;
    }
    run.count(kept);
  }
  EXPECT_EQ(summary(run), "3 places, 2 joined to what was taught before, or to its own beginning");
}

TEST(TaughtRun, SaysWhatItWasToldApartFrom) {
  TaughtRun run;
  run.experience = ExperienceId{1};
  run.told_apart = {ExperienceId{2}, ExperienceId{3}};
  const std::string said = summary(run);
  EXPECT_NE(said.find("looks like run " + to_string(ExperienceId{2}) + ", " + to_string(ExperienceId{3})),
            std::string::npos)
      << said;
}

}  // namespace
}  // namespace weft::agents::test
