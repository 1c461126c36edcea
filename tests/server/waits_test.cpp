#include "server/traffic/waits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::set<RobotId> robots(std::initializer_list<std::uint8_t> numbers) {
  std::set<RobotId> all;
  for (const std::uint8_t number : numbers) all.insert(robot_id(number));
  return all;
}

Wait waiting(std::uint8_t robot, std::initializer_list<std::uint8_t> holders) {
  Wait wait;
  wait.robot = robot_id(robot);
  wait.held_by = robots(holders);
  return wait;
}

TEST(Waits, WhoWaitsForOneThatMovesIsNotInAStandstill) {
  EXPECT_THAT(standstills({waiting(1, {2})}, {}), IsEmpty());
  EXPECT_THAT(standstills({}, {{robot_id(1), Stays::idle}}), IsEmpty());
}

TEST(Waits, TwoThatWaitForEachOtherAreNamedWithWhoWaitsBehind) {
  const auto found = standstills({waiting(1, {2}), waiting(2, {1}), waiting(3, {2}), waiting(4, {3})}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].core, ElementsAre(robot_id(1), robot_id(2)));
  EXPECT_THAT(found[0].behind, ElementsAre(robot_id(3), robot_id(4)));
}

TEST(Waits, CyclesOfAnyLengthAreNamedInOrder) {
  for (std::uint8_t size = 2; size <= 8; ++size) {
    std::vector<Wait> all;
    for (std::uint8_t i = 1; i <= size; ++i) all.push_back(waiting(i, {static_cast<std::uint8_t>(i % size + 1)}));
    const auto found = standstills(all, {});
    ASSERT_EQ(found.size(), 1U) << int{size};
    for (std::uint8_t i = 1; i <= size; ++i) EXPECT_EQ(found[0].core[i - 1U], robot_id(i));
  }
}

TEST(Waits, ACycleOverTheSecondBlockerIsFound) {
  const auto found = standstills({waiting(1, {2, 3}), waiting(3, {1})}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].core, ElementsAre(robot_id(1), robot_id(3)));
}

TEST(Waits, AChainThatEndsInARobotThatStaysIsNamedByIt) {
  const auto found = standstills({waiting(1, {2}), waiting(2, {3}), waiting(5, {6})}, {{robot_id(3), Stays::silent}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].core, ElementsAre(robot_id(3)));
  EXPECT_EQ(found[0].stays, Stays::silent);
  EXPECT_THAT(found[0].behind, ElementsAre(robot_id(2), robot_id(1)));
}

TEST(Waits, WhoStaysWaitsForNobody) {
  const auto found = standstills({waiting(1, {2}), waiting(2, {1})}, {{robot_id(2), Stays::paused}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].core, ElementsAre(robot_id(2)));
}

TEST(Waits, ACycleThatWaitsForOneThatStaysIsNamedBesideIt) {
  const auto found = standstills({waiting(1, {2}), waiting(2, {1, 9})}, {{robot_id(9), Stays::idle}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].core, ElementsAre(robot_id(1), robot_id(2)));
  EXPECT_THAT(found[1].core, ElementsAre(robot_id(9)));
}

TEST(Waits, CyclesThatShareARobotAreOneStandstill) {
  const auto found = standstills({waiting(1, {2, 3}), waiting(2, {1}), waiting(3, {1})}, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].core, ElementsAre(robot_id(1), robot_id(2), robot_id(3)));
}

}  // namespace
}  // namespace weft::server::test
