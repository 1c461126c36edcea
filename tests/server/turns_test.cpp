#include "server/dispatcher/turns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weft::server {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

struct TurnsOfGoals : testing::Test {
  Goal goal(std::uint8_t number, std::uint8_t priority) const {
    Goal made;
    made.id.bytes[0] = number;
    made.number = number;
    made.priority = priority;
    return made;
  }
  std::vector<std::uint64_t> in_turn(const std::vector<const Goal*>& goals, SteadyTime now) {
    std::vector<std::uint64_t> numbers;
    for (const Goal* const one : turns.in_turn(goals, now)) numbers.push_back(one->number);
    return numbers;
  }

  Goal first = goal(1, 0);
  Goal second = goal(2, 0);
  Goal urgent = goal(3, 2);
  SteadyTime start{1000s};
  Turns turns;
};

TEST_F(TurnsOfGoals, ThoseOfAClassComeInTheirOrder) {
  EXPECT_THAT(in_turn({&first, &second}, start), ElementsAre(1, 2));
  EXPECT_THAT(in_turn({&first, &second}, start + 1h), ElementsAre(1, 2));
}

TEST_F(TurnsOfGoals, TheMostUrgentComesFirst) {
  EXPECT_THAT(in_turn({&first, &second, &urgent}, start), ElementsAre(3, 1, 2));
}

TEST_F(TurnsOfGoals, WhoHasWaitedLongComesBeforeTheUrgent) {
  in_turn({&first}, start);
  EXPECT_THAT(in_turn({&first, &second, &urgent}, start + 3min), ElementsAre(3, 1, 2));
  EXPECT_THAT(in_turn({&first, &urgent}, start + 4min), ElementsAre(1, 3)) << "two classes older, and accepted first";
}

TEST_F(TurnsOfGoals, WaitingCountsAnewForWhoWasAway) {
  in_turn({&first}, start);
  in_turn({}, start + 4min);
  EXPECT_THAT(in_turn({&first, &urgent}, start + 8min), ElementsAre(3, 1));
}

}  // namespace
}  // namespace weft::server
