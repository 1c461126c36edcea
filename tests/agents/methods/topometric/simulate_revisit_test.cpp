#include <gtest/gtest.h>

#include <cmath>

#include "tests/agents/methods/topometric/sim_drive.hpp"

namespace weft::agents {
namespace {

/// Holds a place, and a drive that has gone on from there by a quarter of what places are apart.
struct OnFromAPlace {
  OnFromAPlace(const std::string& site, const Pose2& from) : drive(test::topometric_site(site), from) {
    drive.drive(0.9);
    place = drive.place();
    at = drive.truth();
    drive.drive(0.12);
  }
  Pose2 place_from_robot() const { return at.inverse() * drive.truth(); }
  OrRefusal<Revisited<TopometricContent>> revisit(Topometric::Condition condition, std::uint64_t seed = 3) const {
    return drive.method().simulate_revisit(drive.odometry(), drive.view(), {condition, {0.0, 0.05, 0.03}, seed});
  }
  /// Relates what the other robot sees to the place, from a guess that is off along the way.
  OrRefusal<Related> found(const TopometricContent& seen, double off_m) const {
    constexpr GuessError error = Topometric::revisit_guess;
    const Eigen::Vector3d variances(error.sigma_m * error.sigma_m, error.sigma_m * error.sigma_m,
                                    error.sigma_rad * error.sigma_rad);
    return drive.method().relate(place, seen,
                                 Metric2{place_from_robot() * Pose2{off_m, 0.02, 0.01}, variances.asDiagonal()});
  }

  test::SimDrive drive;
  TopometricContent place;
  Pose2 at;
};

/// Returns a drive towards a corner of the hall; made once.
const OnFromAPlace& hall_drive() {
  static const OnFromAPlace made("hall", {10.0, 1.8, 0.0});
  return made;
}

TEST(TopometricSimulatesRevisits, AHallIsFoundAsItIsAndInHalfTheLight) {
  for (const auto condition : {Topometric::as_is, Topometric::half_light}) {
    const auto other = hall_drive().revisit(condition);
    ASSERT_TRUE(other) << other.error().reason;
    EXPECT_EQ(other->robot_from_other, Pose2{}) << "a pair cannot be drawn from elsewhere";
    const OrRefusal<Related> related = hall_drive().found(other->content, 0.1);
    ASSERT_TRUE(related) << condition << ": " << related.error().reason << " " << related.error().measured;
    const Pose2 off = hall_drive().place_from_robot().inverse() * planar(related->a_from_b);
    EXPECT_LT(off.translation().norm(), 0.05) << condition;
    EXPECT_LT(std::abs(off.heading), 0.02) << condition;
  }
}

TEST(TopometricSimulatesRevisits, ItIsOneFrameThatNoPlaceIsMadeOf) {
  const auto other = hall_drive().revisit(Topometric::as_is);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->content.cloud.cameras.size(), 1U);
  EXPECT_GT(hall_drive().place.cloud.cameras.size(), 1U);
  EXPECT_TRUE(other->content.scan);
}

TEST(TopometricSimulatesRevisits, HalfTheLightLeavesLessToFind) {
  const auto as_is = hall_drive().revisit(Topometric::as_is);
  const auto dark = hall_drive().revisit(Topometric::half_light);
  ASSERT_TRUE(as_is && dark);
  EXPECT_LT(dark->content.cloud.points.size(), as_is->content.cloud.points.size());
}

TEST(TopometricSimulatesRevisits, BetweenFaintWallsItTakesLight) {
  const OnFromAPlace corridor("level11", {16.5, 0.9, 0.0});
  const auto other = corridor.revisit(Topometric::as_is);
  ASSERT_TRUE(other) << other.error().reason;
  const OrRefusal<Related> related = corridor.found(other->content, 0.1);
  EXPECT_TRUE(related) << related.error().reason;
  const auto dark = corridor.revisit(Topometric::half_light);
  ASSERT_FALSE(dark && corridor.found(dark->content, 0.1));
}

TEST(TopometricSimulatesRevisits, RefusesWhatCannotBecomeAPlace) {
  View view = hall_drive().drive.view();
  view.data = Payload{};
  const Topometric& method = hall_drive().drive.method();
  EXPECT_EQ(method.simulate_revisit(hall_drive().drive.odometry(), view, {}).error().reason, "not_a_pair");
  EXPECT_EQ(method.simulate_revisit({}, hall_drive().drive.view(), {}).error().reason, "blind");
}

}  // namespace
}  // namespace weft::agents
