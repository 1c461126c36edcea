#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "agents/perception/particles/particle_filter.hpp"
#include "tests/agents/perception/particles/room.hpp"

namespace weft::agents {
namespace {

const DrawPose kAnywhere = [](Random& random) { return Room::anywhere(random); };

Eigen::Matrix3d small_covariance() {
  return Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal();
}

/// Is led round a circle in the room while its filter follows.
class Led {
 public:
  explicit Led(std::uint64_t seed, const ParticleFilterConfig& config = {})
      : field_(room_.field()), filter_(config, seed), random_(seed + 100) {}

  ParticleFilter& filter() { return filter_; }
  const Pose2& truth() const { return truth_; }
  void put_to(const Pose2& pose) { truth_ = pose; }
  /// Drives on by 0.12 m, the odometry 4 % off and noisy, and updates; where `sees_new`, by a scan in which something
  /// stands a metre away all round.
  ParticleUpdate step(const DrawPose& anywhere = kAnywhere, bool is_told = false, bool sees_new = false) {
    const Pose2 moved = se2_exp({0.12, 0.0, 0.09});
    truth_ = truth_ * moved;
    UncertainMotion said{{moved.x * 1.04 + random_.normal(0.0, 0.005), moved.y, moved.heading},
                         Eigen::Vector3d(1e-4, 1e-5, 1e-4).asDiagonal()};
    filter_.advance(said);
    EXPECT_TRUE(filter_.is_due());
    Scan scan = room_.scan_from(truth_, random_);
    for (Beam& beam : scan.beams) beam.range_m = sees_new ? std::min(beam.range_m, 1.0) : beam.range_m;
    const ToldPose told{truth_, Eigen::Vector3d(4e-4, 4e-4, 1e-4).asDiagonal()};
    return filter_.update(field_, scan, anywhere, is_told ? std::optional(told) : std::nullopt);
  }
  double off_m() const { return (filter_.estimate().chart_from_robot.translation() - truth_.translation()).norm(); }

 private:
  Room room_;
  LikelihoodField field_;
  ParticleFilter filter_;
  Random random_;
  Pose2 truth_{4.5, 2.9, 0.3};
};

TEST(ParticleFilter, FollowsWithinCentimetres) {
  Led led(1);
  led.filter().begin_at(led.truth(), small_covariance(), 500);
  double worst = 0.0;
  for (int i = 0; i < 120; ++i) {
    led.step();
    worst = std::max(worst, led.off_m());
  }
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(std::abs(wrap_angle(led.filter().estimate().chart_from_robot.heading - led.truth().heading)), 0.03);
}

TEST(ParticleFilter, KeepsFewParticlesWhenItKnowsWhereItIs) {
  Led led(2);
  led.filter().begin_anywhere(kAnywhere, 3000);
  EXPECT_EQ(led.filter().particles().size(), 3000U);
  EXPECT_GT(led.step(DrawPose()).scan.blurs, 0) << "none of them is quite there";
  for (int i = 0; i < 60; ++i) led.step(DrawPose());
  EXPECT_EQ(led.step(DrawPose()).scan.blurs, 0);
  EXPECT_EQ(led.filter().particles().size(), 300U);
  EXPECT_LT(led.off_m(), 0.1) << "it began anywhere";
}

TEST(ParticleFilter, FindsItselfAfterAKidnapping) {
  Led led(3);
  led.filter().begin_at(led.truth(), small_covariance(), 500);
  for (int i = 0; i < 40; ++i) led.step();
  ASSERT_LT(led.off_m(), 0.1);
  led.put_to({1.79, 2.55, -2.0});
  double most_injected = 0.0;
  for (int i = 0; i < 80; ++i) most_injected = std::max(most_injected, led.step().injected);
  EXPECT_GT(most_injected, 0.05);
  EXPECT_LT(led.off_m(), 0.15);
}

TEST(ParticleFilter, WithoutAnywhereToDrawFromAKidnappingIsNotRecoveredFrom) {
  Led led(3);
  led.filter().begin_at(led.truth(), small_covariance(), 500);
  for (int i = 0; i < 40; ++i) led.step(DrawPose());
  led.put_to({1.79, 2.55, -2.0});
  for (int i = 0; i < 80; ++i) EXPECT_EQ(led.step(DrawPose()).injected, 0.0);
  EXPECT_GT(led.off_m(), 0.5) << "so it is the injection that recovers it";
}

TEST(ParticleFilter, ItSeeksNothingWhileItIsToldWhereItIs) {
  for (const bool is_told : {true, false}) {
    Led led(6);
    led.filter().begin_at(led.truth(), small_covariance(), 500);
    for (int i = 0; i < 40; ++i) led.step(kAnywhere, is_told);
    double most_injected = 0.0;
    for (int i = 0; i < 20; ++i) most_injected = std::max(most_injected, led.step(kAnywhere, is_told, true).injected);
    if (is_told) {
      EXPECT_EQ(most_injected, 0.0) << "what it sees is new";
      EXPECT_LT(led.off_m(), 0.1);
      EXPECT_EQ(led.step().injected, 0.0) << "nor is it taken to be lost afterwards";
    } else {
      EXPECT_GT(most_injected, 0.05);
    }
  }
}

TEST(ParticleFilter, InjectsNothingWhileAllIsWell) {
  Led led(4);
  led.filter().begin_at(led.truth(), small_covariance(), 500);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(led.step().injected, 0.0) << i;
}

TEST(ParticleFilter, TheSameSeedGivesTheSameParticles) {
  Led one(5);
  Led same(5);
  for (Led* const led : {&one, &same}) {
    led->filter().begin_anywhere(kAnywhere, 1000);
    for (int i = 0; i < 5; ++i) led->step();
  }
  EXPECT_EQ(one.filter().particles().x, same.filter().particles().x);
  EXPECT_EQ(one.filter().particles().heading, same.filter().particles().heading);
}

TEST(ParticleFilter, IsDueAfterADecimetreOrHalfADegree) {
  Led led(6);
  led.filter().begin_at(led.truth(), small_covariance(), 300);
  EXPECT_TRUE(led.filter().is_due()) << "nothing was seen yet";
  led.step();
  EXPECT_FALSE(led.filter().is_due());
  led.filter().advance({{0.09, 0.0, 0.008}, Eigen::Matrix3d::Zero()});
  EXPECT_FALSE(led.filter().is_due());
  led.filter().advance({{0.0, 0.0, 0.001}, Eigen::Matrix3d::Zero()});
  EXPECT_TRUE(led.filter().is_due());
}

TEST(ParticleFilter, AScanWithoutReturnsMovesItAndTellsNothing) {
  const Room room;
  ParticleFilter filter({}, 7);
  filter.begin_at({2.0, 2.0, 0.0}, small_covariance(), 2000);
  filter.advance({{0.5, 0.0, 0.0}, Eigen::Matrix3d::Zero()});
  EXPECT_EQ(filter.update(room.field(), Scan{}, kAnywhere).scan.power, 0.0);
  EXPECT_NEAR(filter.estimate().chart_from_robot.x, 2.5, 0.02);
  EXPECT_EQ(filter.particles().size(), 2000U);
}

TEST(ParticleFilter, GoesOnInAnotherChartWithTheSameBelief) {
  Led led(8);
  led.filter().begin_at(led.truth(), small_covariance(), 500);
  for (int i = 0; i < 20; ++i) led.step();
  const ParticleEstimate before = led.filter().estimate();
  const Pose2 new_from_old{3.0, -2.0, 1.1};
  led.filter().carry_to(new_from_old);
  const ParticleEstimate after = led.filter().estimate();
  const Pose2 off = (new_from_old * before.chart_from_robot).inverse() * after.chart_from_robot;
  EXPECT_LT(off.translation().norm(), 1e-6);
  EXPECT_LT((before.covariance - after.covariance).norm(), 1e-9);
}

TEST(ParticleFilter, SettingsOutOfBoundsAreNamed) {
  ParticleFilterConfig config;
  EXPECT_TRUE(check(config).empty());
  config.kld.least = 5000;
  config.recovery.slow = 0.5;
  const std::vector<Error> issues = check(config);
  ASSERT_EQ(issues.size(), 2U);
  EXPECT_NE(issues[0].message.find("particles: kld.least is 5000"), std::string::npos) << issues[0].message;
}

}  // namespace
}  // namespace weft::agents
