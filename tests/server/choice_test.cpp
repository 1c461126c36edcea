#include "server/dispatcher/choice.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace weft::server::test {
namespace {

struct ChoiceTest : testing::Test {
  /// Adds a robot that has it so far; none: there is no way for it.
  void put(std::uint8_t number, std::optional<double> length_m) {
    const RobotId robot{number, number};
    candidates.push_back({.robot = robot, .at = {ExperienceId{number}, 0}, .methods = {"marks"}});
    lengths_m[robot] = length_m;
  }
  FindWay find() {
    return [this](const Candidate& candidate) -> Result<Path> {
      ++searches;
      if (!lengths_m.at(candidate.robot)) return fail(error, "no way");
      Path path;
      path.length_m = *lengths_m.at(candidate.robot);
      return path;
    };
  }
  std::optional<Result<Choice>> go_on(std::size_t most) { return choosing.go_on(candidates, find(), most); }

  std::vector<Candidate> candidates;
  std::map<RobotId, std::optional<double>> lengths_m;
  ErrorCode error = ErrorCode::not_found;
  int searches = 0;
  Choosing choosing;
};

TEST_F(ChoiceTest, TheNearestIsChosenAndOfEquallyNearOnesTheFirst) {
  put(3, 5.0);
  put(2, 5.0);
  put(1, 7.0);
  const Result<Choice> choice = choose(candidates, find());
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->robot, (RobotId{2, 2}));
}

TEST_F(ChoiceTest, NobodyThatGetsThereIsSaidWithTheReason) {
  put(1, std::nullopt);
  const Result<Choice> choice = choose(candidates, find());
  ASSERT_FALSE(choice);
  EXPECT_EQ(choice.error().message, "no way");
  EXPECT_FALSE(choose({}, find()));
}

TEST_F(ChoiceTest, InPiecesItIsTheSameWithAsManySearches) {
  for (std::uint8_t number = 1; number <= 10; ++number) put(number, 20.0 - static_cast<double>(number % 7));
  const Result<Choice> whole = choose(candidates, find());
  ASSERT_TRUE(whole);
  EXPECT_EQ(searches, 10);
  searches = 0;
  for (int piece = 0; piece < 3; ++piece) EXPECT_FALSE(go_on(3));
  const std::optional<Result<Choice>> choice = go_on(3);
  ASSERT_TRUE(choice && *choice);
  EXPECT_EQ((*choice)->robot, whole->robot);
  EXPECT_EQ((*choice)->path.length_m, whole->path.length_m);
  EXPECT_EQ(searches, 10);
}

TEST_F(ChoiceTest, WhoIsGoneMeanwhileIsNotChosen) {
  put(1, 1.0);
  put(2, 2.0);
  put(3, 3.0);
  EXPECT_FALSE(go_on(2));
  candidates.erase(candidates.begin());
  const std::optional<Result<Choice>> choice = go_on(2);
  ASSERT_TRUE(choice && *choice);
  EXPECT_EQ((*choice)->robot, (RobotId{2, 2}));
  EXPECT_EQ((*choice)->path.length_m, 2.0);
}

TEST_F(ChoiceTest, WhoStandsElsewhereMeanwhileIsLookedAtAgain) {
  put(1, 1.0);
  put(2, 2.0);
  put(3, 3.0);
  EXPECT_FALSE(go_on(2));
  candidates.front().at.index = 7;
  lengths_m[candidates.front().robot] = 9.0;
  EXPECT_FALSE(go_on(1));
  const std::optional<Result<Choice>> choice = go_on(1);
  ASSERT_TRUE(choice && *choice);
  EXPECT_EQ((*choice)->robot, (RobotId{2, 2}));
}

TEST_F(ChoiceTest, WhoseWayWasRefusedIsNamed) {
  put(1, std::nullopt);
  error = ErrorCode::refused;
  ASSERT_TRUE(go_on(1));
  EXPECT_EQ(choosing.refused(), std::set<RobotId>({RobotId{1, 1}}));
}

}  // namespace
}  // namespace weft::server::test
