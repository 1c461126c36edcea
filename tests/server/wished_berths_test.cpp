#include "server/traffic/plan/wished_berths.hpp"

#include <gtest/gtest.h>

namespace weft::server::test {
namespace {

constexpr BerthArc kTo2{.to = 2, .length_m = 1.0, .middle = 7, .touches = {}};

TEST(WishedBerths, AWishThatIsTakenBackIsGone) {
  WishedBerths wished;
  wished.drive(kTo2, 0);
  EXPECT_EQ(wished.who_wishes(2), 0U);
  EXPECT_EQ(wished.who_wishes(7), 0U);
  wished.take_back(kTo2, 0);
  EXPECT_EQ(wished.who_wishes(2), kNobody);
  EXPECT_EQ(wished.who_wishes(7), kNobody);
}

/// Asks the robot that stands there to make way while the wish is there; it finds that it has to stay.
TEST(WishedBerths, WhoWasAskedAndStaysStillWishesToWhenTheAskerTakesItsWishBack) {
  WishedBerths wished;
  wished.drive(kTo2, 0);
  wished.stay(2, {}, 1);
  wished.take_back(kTo2, 0);
  EXPECT_EQ(wished.who_wishes(2), 1U);
}

}  // namespace
}  // namespace weft::server::test
