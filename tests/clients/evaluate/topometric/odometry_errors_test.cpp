#include "clients/evaluate/topometric/odometry_errors.hpp"

#include <gmock/gmock.h>

namespace weft::evaluate::topometric {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

/// Drives straight on, 5 cm a sample, all of it seen and told as it is.
Moments straight(std::size_t count) {
  Moments moments(count);
  for (std::size_t i = 0; i < count; ++i) {
    moments[i].seen = true;
    moments[i].step = i == 0 ? Pose2{} : Pose2{0.05, 0.0, 0.0};
    moments[i].start_from_robot = {0.05 * static_cast<double>(i), 0.0, 0.0};
    moments[i].site_from_robot = Pose2{3.0, 1.0, 1.0} * moments[i].start_from_robot;
    moments[i].true_s = 0.1 * static_cast<double>(i);
  }
  return moments;
}

TEST(OdometryErrors, AreFromWhereTheChainBegan) {
  Moments moments = straight(3);
  for (Moment& moment : moments) moment.start_from_robot = Pose2{-7.0, 2.0, 0.3} * moment.start_from_robot;
  moments[2].start_from_robot = moments[2].start_from_robot * Pose2{0.03, -0.04, 0.2};
  EXPECT_THAT(chain_errors_m(moments, &Moment::start_from_robot),
              ElementsAre(DoubleNear(0.0, 1e-12), DoubleNear(0.0, 1e-12), DoubleNear(0.05, 1e-12)));
  EXPECT_NEAR(metres_in(moments), 0.1, 1e-12);
}

TEST(FollowedSteps, ASeenStepThatIsOffIsWrongAndABlindOneIsNot) {
  Moments moments = straight(6);
  moments[2].step.x += 0.03;
  moments[4].step.x += 0.03;
  moments[4].seen = false;
  const FollowedSteps followed = followed_steps(moments);
  EXPECT_EQ(followed.samples, 5.0);
  EXPECT_EQ(followed.blind, 1.0);
  EXPECT_EQ(followed.wrong, 1.0);
  EXPECT_NEAR(followed.largest_wrong_m, 0.03, 1e-12);
}

TEST(FollowedSteps, TakingBackWhatWasAssumedIsNoError) {
  Moments moments = straight(6);
  moments[2].seen = moments[3].seen = false;
  moments[2].step = moments[3].step = {};
  moments[4].step = {0.15, 0.0, 0.0};  // the three steps together
  EXPECT_EQ(followed_steps(moments).wrong, 0.0);
  EXPECT_EQ(followed_steps(moments).blind, 2.0);
}

TEST(FollowedSteps, StandingIsNothingToBeBlindTo) {
  Moments moments = straight(3);
  Moment stands = moments.back();
  stands.step = {};
  stands.seen = false;
  moments.push_back(stands);
  EXPECT_EQ(followed_steps(moments).samples, 2.0);
  EXPECT_EQ(followed_steps(moments).blind, 0.0);
}

TEST(Hidden, WhatIsTakenFromADarkOrCoveredViewIsCounted) {
  agents::sim::Site site;
  site.blackouts = {{.kind = agents::sim::Blackout::Kind::covered, .from_s = 0.15, .to_s = 0.35},
                    {.kind = agents::sim::Blackout::Kind::frozen, .from_s = 0.35, .to_s = 9.0}};
  Moments moments = straight(6);
  for (Moment& moment : moments) moment.fix = BelievedAt{};
  moments[3].kept = PlaceId{};
  moments[5].kept = PlaceId{};
  EXPECT_EQ(fixes_while_hidden(site, moments), 2.0);
  EXPECT_EQ(kept_while_hidden(site, moments), 1.0);
}

}  // namespace
}  // namespace weft::evaluate::topometric
