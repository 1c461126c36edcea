#include "agents/perception/rocking_centre.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

/// Tests that where a robot went is told from where its shaking camera went.
namespace weft::agents {
namespace {

using namespace std::chrono_literals;

struct Shaken {
  double height_m = 0.0;  ///< about which it rocks
  bool has_wheels = true;
  double turn_rad = 0.0;  ///< a step
  double tilt_rad = 0.0009;
};

struct Told {
  RockingCentre rocking{0.6};
  double worst_m = 0.0;  ///< of the corrected steps, once it had learned
};

Told drive(const Shaken& how, std::uint64_t seed, int steps = 600) {
  Random random(seed);
  Told told;
  Attitude before;
  for (int i = 0; i < steps; ++i) {
    const double speed_m = 0.02 * (1.0 + 0.3 * std::sin(0.02 * i));
    const Pose2 truth = se2_exp({speed_m, 0.0, how.turn_rad});
    const Attitude now{how.tilt_rad * random.normal(), how.tilt_rad * random.normal(), 0.0};
    const Attitude change = Attitude::from(now.vector() - before.vector());
    before = now;
    Motion motion{.elapsed = 33ms, .command = {speed_m / 0.033, how.turn_rad / 0.033}, .wheels = {}};
    if (how.has_wheels) motion.wheels = WheelStep{1.03 * speed_m + 0.0002 * random.normal(), how.turn_rad};
    const Pose2 seen{truth.x - how.height_m * change.pitch_rad + 0.0001 * random.normal(),
                     truth.y + how.height_m * change.roll_rad + 0.0001 * random.normal(), truth.heading};
    told.rocking.learn(seen, change, motion);
    const Pose2 corrected = told.rocking.corrected(seen, change);
    if (i > 300) told.worst_m = std::max(told.worst_m, std::hypot(corrected.x - truth.x, corrected.y - truth.y));
  }
  return told;
}

TEST(RockingCentre, LearnsItsHeightWithAndWithoutWheels) {
  for (const double height : {0.0, 0.2, 0.6}) {
    for (const bool has_wheels : {true, false}) {
      for (const double turn : {0.0, 0.02}) {
        const Told told = drive({height, has_wheels, turn}, 7);
        EXPECT_NEAR(told.rocking.height_m(), height, 3.0 * told.rocking.sigma_m());
        EXPECT_LT(told.rocking.sigma_m(), 0.03);
        EXPECT_LT(told.worst_m, 0.0007) << "up to 2 mm uncorrected";
      }
    }
  }
}

TEST(RockingCentre, IsUnknownWhereNothingShakes) {
  const Told told = drive({.height_m = 0.6, .has_wheels = true, .turn_rad = 0.0, .tilt_rad = 0.0}, 1);
  EXPECT_GT(told.rocking.sigma_m(), 0.2);
  EXPECT_GE(told.rocking.height_m(), 0.0);
  EXPECT_LE(told.rocking.height_m(), 0.6);
}

TEST(RockingCentre, AStepThatIsWrongAltogetherTeachesNothing) {
  Told told = drive({.height_m = 0.3, .has_wheels = true, .turn_rad = 0.0}, 3);
  const double before = told.rocking.height_m();
  const Motion motion{.elapsed = 33ms, .command = {0.6, 0.0}, .wheels = WheelStep{0.02, 0.0}};
  told.rocking.learn({0.2, 0.1, 0.0}, {0.002, 0.002, 0.0}, motion);
  EXPECT_NEAR(told.rocking.height_m(), before, 1e-3);
}

}  // namespace
}  // namespace weft::agents
