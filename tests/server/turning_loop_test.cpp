#include <gtest/gtest.h>

#include <numbers>

#include "server/traffic/plan/berths.hpp"
#include "server/traffic/plan/lanes.hpp"
#include "tests/server/surveyed_site.hpp"

namespace weft::server::test {
namespace {

constexpr double kHalfTurn_rad = std::numbers::pi;
constexpr double kRobotFootprint_m = 0.3;  ///< two robots keep 1.2 m apart

/// A lane of 6 m, a loop at its end where robots turn, and the same lane back and on.
struct TurningLoopTest : testing::Test {
  void lay(double loop_m) {
    run = site.teach(Lane({})
                         .ahead(6.0)
                         .bend(-kHalfTurn_rad / 4.0, 0.5)
                         .bend(1.5 * kHalfTurn_rad, loop_m)
                         .bend(-kHalfTurn_rad / 4.0, 0.5)
                         .ahead(14.0));
    proximity.emplace(proximity_of(site.network()));
    berths.emplace(*proximity);
    berths->follow({shared(site.network()), &no_rules}, kRobotFootprint_m);
    lanes.emplace(*berths);
    methods = berths->methods({{"floor"}, true});
  }
  Lanes::Stand stand(double along_m) {
    return {berths->at(SurveyedSite::place(run, static_cast<std::uint32_t>(along_m / kSpacing_m))), methods};
  }

  SurveyedSite site{1};
  std::uint64_t run = 0;
  std::optional<Proximity> proximity;
  const RuleMap no_rules;
  std::optional<Berths> berths;
  std::optional<Lanes> lanes;
  std::uint32_t methods = 0;
};

TEST_F(TurningLoopTest, WhoFollowsIntoALoopForOneMeetsTheOneThatComesOut) {
  lay(2.5);
  EXPECT_TRUE(lanes->meet(stand(5.0), stand(3.75)));
}

TEST_F(TurningLoopTest, InALoopWithRoomForTwoTheyDriveOneBehindTheOther) {
  lay(14.0);
  EXPECT_FALSE(lanes->meet(stand(5.0), stand(3.75)));
}

}  // namespace
}  // namespace weft::server::test
