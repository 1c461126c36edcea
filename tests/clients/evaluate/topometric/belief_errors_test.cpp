#include "clients/evaluate/topometric/belief_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::topometric {
namespace {

const PlaceId kPlace{ExperienceId{1}, 4};
const Pose2 kSiteFromPlace{5.0, 2.0, 1.2};
const TruePlaces kPlaces = {{kPlace, kSiteFromPlace}};

/// Stands 0.3 m before the place, and believes to be so much beside that.
Moment at_place(const Pose2& truth_from_believed, double sigma_m = 0.02) {
  Moment moment;
  const Pose2 place_from_robot{-0.3, 0.0, 0.0};
  moment.site_from_robot = kSiteFromPlace * place_from_robot;
  moment.believed =
      BelievedAt{kPlace, place_from_robot * truth_from_believed, sigma_m * sigma_m * Eigen::Matrix3d::Identity()};
  moment.following = agents::Following::driving;
  moment.command = {0.4, 0.0};
  return moment;
}

TEST(BeliefErrors, AreRelativeToTheBelievedPlace) {
  Moment lost = at_place({9.0, 0.0, 0.0});
  lost.lost = true;
  Moment elsewhere = at_place({});
  elsewhere.believed->place.index = 5;
  const BeliefErrors errors = belief_errors({at_place({0.03, -0.04, 0.1}), lost, elsewhere}, kPlaces);
  ASSERT_EQ(errors.metres.size(), 1U);
  EXPECT_NEAR(errors.metres[0], 0.05, 1e-12);
  EXPECT_NEAR(errors.radians[0], 0.1, 1e-12);
}

TEST(BeliefErrors, FixesHoldWhatTheirEllipseHolds) {
  Moments moments = {at_place({0.05, 0.0, 0.0}), at_place({0.06, 0.0, 0.0}), at_place({})};
  for (Moment& moment : moments) moment.fix = moment.believed;
  const FixErrors errors = fix_errors(moments, kPlaces);
  EXPECT_NEAR(errors.held_percent, 200.0 / 3.0, 1e-9);  // 2.5 sigma is held, 3 sigma is not
  EXPECT_NEAR(errors.mean_nees, (2.5 * 2.5 + 3.0 * 3.0) / 3.0, 1e-9);
  EXPECT_TRUE(std::isnan(fix_errors({}, kPlaces).held_percent));
}

TEST(SwitchErrors, TellTheJumpAndHowLongItStood) {
  Moments moments(60, at_place({}));
  for (std::size_t i = 0; i < moments.size(); ++i) moments[i].sensor_s = 0.1 * static_cast<double>(i);
  moments[45].has_switched = true;
  moments[45].jump_m = 0.02;
  moments[46].command = moments[47].command = {};
  moments[58].command = {};        // long after
  moments[5].has_switched = true;  // it sets out
  moments[5].jump_m = 0.5;
  const SwitchErrors errors = switch_errors(moments);
  ASSERT_EQ(errors.jumps_m.size(), 1U);
  EXPECT_EQ(errors.jumps_m[0], 0.02);
  EXPECT_NEAR(errors.stands_s[0], 0.2, 1e-9);
}

TEST(BeliefErrors, RightIsWithinBothBounds) {
  const Moment moment = at_place({0.2, 0.0, 0.05});
  EXPECT_TRUE(is_believed_right(*moment.believed, moment.site_from_robot, kPlaces, 0.3, 0.1));
  EXPECT_FALSE(is_believed_right(*moment.believed, moment.site_from_robot, kPlaces, 0.1, 0.1));
  EXPECT_FALSE(is_believed_right(*moment.believed, moment.site_from_robot, kPlaces, 0.3, 0.01));
  EXPECT_FALSE(is_believed_right(*moment.believed, moment.site_from_robot, {}, 0.3, 0.1));
}

}  // namespace
}  // namespace weft::evaluate::topometric
