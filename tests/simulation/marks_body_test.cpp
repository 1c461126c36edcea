#include "tests/simulation/marks_body.hpp"

#include <gtest/gtest.h>

namespace weft::simulation {
namespace {

TEST(MarksBody, SaysItsChargeOnlyWhereItHasABattery) {
  const auto site = std::make_shared<const Site>(make_site("ring", Random(1)));
  const Pose2 start = site->pose(0.0, {});
  MarksBody plain(site, start, Random(2));
  EXPECT_FALSE(plain.step({0.4, 0.0})->charge);
  MarksBody body(site, start, Random(2));
  body.equip(agents::Battery({.share = 0.5, .drains_per_m = 0.01, .chargers = {{start.x, start.y}}}));
  EXPECT_TRUE(body.step({})->charge.value().is_charging);
  double share = 0.0;
  for (int step = 0; step < 100; ++step) share = body.step({0.4, 0.0})->charge.value().share;
  EXPECT_LT(share, 0.49) << "it has driven some metres";
}

}  // namespace
}  // namespace weft::simulation
