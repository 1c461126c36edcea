#include "core/network/site_frame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace weft {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
const Pose2 kTruth{12.0, -3.5, 1.1};

/// Returns places of a map of 40 m by 25 m, picked on the plan with noise.
std::vector<SitePick> picked(std::size_t count, double noise_m, Random& random) {
  std::vector<SitePick> picks;
  for (std::size_t i = 0; i < count; ++i) {
    SitePick pick;
    pick.name = "p" + std::to_string(i);
    pick.layout_from_place = {random.uniform(0.0, 40.0), random.uniform(0.0, 25.0), random.uniform(-3.0, 3.0)};
    pick.in_place = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    pick.on_plan = kTruth * (pick.layout_from_place * pick.in_place) +
                   Eigen::Vector2d(random.normal(0.0, noise_m), random.normal(0.0, noise_m));
    picks.push_back(pick);
  }
  return picks;
}

double error_m(const Pose2& found) {
  const Eigen::Vector2d middle{20.0, 12.5};
  return (found * middle - kTruth * middle).norm();
}

TEST(SiteFrame, ExactPicksGiveTheExactFrame) {
  Random random(2001);
  const Result<SiteFrame> frame = fit_site_frame(picked(3, 0.0, random));
  ASSERT_TRUE(frame) << frame.error().message;
  EXPECT_NEAR(error_m(frame->plan_from_layout), 0.0, 1e-9);
  EXPECT_NEAR(frame->plan_from_layout.heading, kTruth.heading, 1e-9);
  EXPECT_NEAR(frame->scale, 1.0, 1e-9);
  EXPECT_TRUE(frame->left_out.empty());
}

TEST(SiteFrame, FourToEightPicksWithFiveCentimetresOfNoiseHoldAMapOfFortyMetres) {
  Random random(2002);
  std::vector<double> off;
  std::vector<double> turned;
  for (int trial = 0; trial < 500; ++trial) {
    const Result<SiteFrame> frame = fit_site_frame(picked(4 + static_cast<std::size_t>(trial % 5), 0.05, random));
    ASSERT_TRUE(frame) << frame.error().message;
    off.push_back(error_m(frame->plan_from_layout));
    turned.push_back(std::abs(frame->plan_from_layout.heading - kTruth.heading));
  }
  std::sort(off.begin(), off.end());
  std::sort(turned.begin(), turned.end());
  EXPECT_LE(off[250], 0.03);
  EXPECT_LE(off[450], 0.06);
  EXPECT_LE(turned[250], 0.3 * kDegree);
}

TEST(SiteFrame, APickThatIsAMetreWrongAmongFiveIsNamedEachTime) {
  Random random(2003);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<SitePick> picks = picked(5, 0.05, random);
    const double way = random.uniform(-3.14, 3.14);
    picks[2].on_plan += Eigen::Vector2d(std::cos(way), std::sin(way));
    const Result<SiteFrame> frame = fit_site_frame(picks);
    ASSERT_TRUE(frame) << frame.error().message;
    ASSERT_FALSE(frame->left_out.empty()) << trial;
    EXPECT_EQ(frame->left_out.front(), 2U) << trial;
    EXPECT_GT(frame->off_m[2], 0.7) << "it is told how far off it is";
  }
}

TEST(SiteFrame, OfThreePicksNoneIsLeftOut) {
  Random random(2004);
  std::vector<SitePick> picks = picked(3, 0.01, random);
  picks[0].on_plan.x() += 1.0;
  const Result<SiteFrame> frame = fit_site_frame(picks);
  ASSERT_TRUE(frame);
  EXPECT_TRUE(frame->left_out.empty());
  EXPECT_GT(*std::max_element(frame->off_m.begin(), frame->off_m.end()), 0.2);
}

TEST(SiteFrame, AStretchedMapIsToldAndNotStretched) {
  Random random(2005);
  std::vector<SitePick> picks = picked(6, 0.0, random);
  for (SitePick& pick : picks)
    pick.on_plan = kTruth * Eigen::Vector2d(pick.layout_from_place * pick.in_place / 1.017);
  const Result<SiteFrame> frame = fit_site_frame(picks);
  ASSERT_TRUE(frame);
  EXPECT_NEAR(frame->scale, 1.0 / 1.017, 1e-6);
  const Eigen::Vector2d a = frame->plan_from_layout * Eigen::Vector2d(0.0, 0.0);
  const Eigen::Vector2d b = frame->plan_from_layout * Eigen::Vector2d(10.0, 0.0);
  EXPECT_NEAR((a - b).norm(), 10.0, 1e-9);
}

TEST(SiteFrame, OnePickNeedsAHeading) {
  SitePick pick{"dock", {1.0, 2.0, 0.5}, Eigen::Vector2d::Zero(), {7.0, 8.0}, std::nullopt, 0.05};
  const Result<SiteFrame> without = fit_site_frame({pick});
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message.find("dock=X,Y,HEADING"), std::string::npos) << without.error().message;
  pick.heading = 1.5;
  const Result<SiteFrame> frame = fit_site_frame({pick});
  ASSERT_TRUE(frame);
  const Pose2 there = frame->plan_from_layout * pick.layout_from_place;
  EXPECT_NEAR(there.x, 7.0, 1e-12);
  EXPECT_NEAR(there.y, 8.0, 1e-12);
  EXPECT_NEAR(there.heading, 1.5, 1e-12);
}

TEST(SiteFrame, PicksInOnePointAndSigmasOutOfBoundsAreRefused) {
  const SitePick pick{"dock", {1.0, 2.0, 0.5}, Eigen::Vector2d::Zero(), {7.0, 8.0}, std::nullopt, 0.05};
  SitePick beside = pick;
  beside.on_plan.x() += 0.5;
  beside.layout_from_place.x += 0.5;
  beside.name = "gate";
  const auto refusal = [&] { return fit_site_frame({pick, beside}).error().message; };
  EXPECT_NE(refusal().find("dock and gate come nearest to it: they lie 0.50 m apart in the map and 0.50 m apart on"),
            std::string::npos)
      << refusal();
  beside.on_plan.x() += 12.0;
  EXPECT_NE(refusal().find("0.50 m apart in the map and 12.50 m apart on the plan"), std::string::npos) << refusal();
  beside.layout_from_place = pick.layout_from_place;
  EXPECT_NE(refusal().find("at one spot of the map and 12.50 m apart on the plan"), std::string::npos) << refusal();
  beside.sigma_m = 0.0;
  EXPECT_NE(fit_site_frame({pick, beside}).error().message.find("from 0.001 to 10 m"), std::string::npos);
  EXPECT_FALSE(fit_site_frame({}));
}

TEST(SiteFrame, StatesHowSureItIs) {
  Random random(2006);
  double squares = 0.0;
  double stated = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::vector<SitePick> picks = picked(6, 0.05, random);
    const SiteFrame frame = *fit_site_frame(picks);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const SitePick& pick : picks) middle += pick.layout_from_place * pick.in_place / 6.0;
    squares += (frame.plan_from_layout * middle - kTruth * middle).squaredNorm() / 2.0;
    stated += frame.sigma_m * frame.sigma_m;
  }
  EXPECT_NEAR(std::sqrt(squares / stated), 1.0, 0.25);
}

}  // namespace
}  // namespace weft
