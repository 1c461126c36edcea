#include "agents/agent/place_learning.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {

struct LearningBench : Bench {
  explicit LearningBench(std::uint32_t places = 3) : laid(lay_out(server, 70, places)) { fetch_map(false); }
  LearnedPlace learned_place(std::uint32_t index, std::uint64_t seed) const {
    const Place& known = *map.window().place({laid, index});
    return {known.id, known.content.hash, 2, some_content(seed, 20)};
  }
  std::size_t take(LearnedPlace learned_place) {
    return learning.take({std::move(learned_place)}, map.window(), {.robot = {}, .frame = 5, .at = {}});
  }
  std::string hand_in(bool drives) { return learning.hand_in(drives, spooler, ids, now); }
  ExperienceId laid;
  PlaceLearning learning;
};

TEST(PlaceLearning, WaitsForTheEndOfTheDrive) {
  LearningBench bench;
  EXPECT_EQ(bench.hand_in(false), "") << "nothing was learned";
  EXPECT_EQ(bench.take(bench.learned_place(1, 1)), 1U);
  EXPECT_EQ(bench.hand_in(true), "");
  EXPECT_EQ(bench.hand_in(false), "knows 1 places better: handed in");
  EXPECT_EQ(bench.hand_in(false), "") << "once";
}

TEST(PlaceLearning, LearnedPlaceUponAContentThatIsGoneIsVoid) {
  LearningBench bench;
  LearnedPlace learned_place = bench.learned_place(1, 1);
  learned_place.made_of = hash_bytes(some_content(99, 5));
  EXPECT_EQ(bench.take(learned_place), 0U);
  learned_place = bench.learned_place(1, 1);
  learned_place.place.index = 77;
  EXPECT_EQ(bench.take(learned_place), 0U);
}

TEST(PlaceLearning, NewerLearnedPlaceOfTheSamePlaceReplacesTheOlder) {
  LearningBench bench;
  bench.take(bench.learned_place(1, 1));
  const LearnedPlace newer = bench.learned_place(1, 2);
  bench.take(newer);
  EXPECT_EQ(bench.hand_in(false), "knows 1 places better: handed in");
  ASSERT_EQ(bench.disk->records.size(), 1U);
  EXPECT_EQ(bench.disk->records.front().batch.learned.front().content.hash, hash_bytes(newer.content));
  EXPECT_EQ(bench.disk->records.front().batch.learned.front().frame, 5U);
}

TEST(PlaceLearning, LongDriveIsHandedInNowAndThen) {
  LearningBench bench(500);
  for (std::uint32_t index = 0; index < 499; ++index) bench.take(bench.learned_place(index, index));
  EXPECT_EQ(bench.hand_in(true), "");
  bench.take(bench.learned_place(499, 499));
  EXPECT_EQ(bench.hand_in(true), "knows 500 places better: handed in");
}

TEST(PlaceLearning, FullDiskLosesItAndSaysSo) {
  LearningBench bench;
  bench.take(bench.learned_place(1, 1));
  bench.disk->faults.full = true;
  EXPECT_EQ(bench.hand_in(false).rfind("what it has learned of 1 places is lost: ", 0), 0U);
}

}  // namespace
}  // namespace weft::agents::test
