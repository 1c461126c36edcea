#include "agents/methods/command_lag.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <deque>

namespace weft::agents {
namespace {

using namespace std::chrono_literals;

constexpr double kSampleS = 0.1;

/// Is a base that obeys late, simulated in milliseconds.
class LateBase {
 public:
  LateBase(double delay_s, double time_constant_s) : delay_ms_(delay_s * 1e3), time_constant_s_(time_constant_s) {}

  Pose2 drive(const Twist& command) {
    Pose2 moved;
    for (int ms = 0; ms < 100; ++ms) {
      waiting_.push_back(command);
      if (static_cast<double>(waiting_.size()) > delay_ms_) {
        const Twist now = waiting_.front();
        waiting_.pop_front();
        const double share = time_constant_s_ > 0.0 ? 1.0 - std::exp(-1e-3 / time_constant_s_) : 1.0;
        rate_.linear_m_s += share * (now.linear_m_s - rate_.linear_m_s);
        rate_.angular_rad_s += share * (now.angular_rad_s - rate_.angular_rad_s);
      }
      moved = moved * se2_exp({1e-3 * rate_.linear_m_s, 0.0, 1e-3 * rate_.angular_rad_s});
    }
    return moved;
  }

 private:
  double delay_ms_;
  double time_constant_s_;
  std::deque<Twist> waiting_;
  Twist rate_;
};

Twist commanded(int sample) {
  return {sample / 8 % 2 == 0 ? 0.4 : 0.1, sample / 5 % 3 == 0 ? 0.5 : -0.2};
}

Motion motion_of(const Twist& command) {
  return {100ms, command, std::nullopt};
}

TEST(CommandLag, IsLearntFromSeenSteps) {
  for (const auto& [delay_s, time_constant_s] : {std::pair{0.2, 0.1}, {0.0, 0.3}, {0.1, 0.0}}) {
    LateBase base(delay_s, time_constant_s);
    CommandLag lag;
    for (int i = 0; i < 80; ++i) {
      lag.next(motion_of(commanded(i)));
      lag.learn(base.drive(commanded(i)));
    }
    EXPECT_NEAR(lag.delay_s(), delay_s, 0.06);
    EXPECT_NEAR(lag.time_constant_s(), time_constant_s, 0.06);
  }
}

TEST(CommandLag, TellsABlindStretchBetterThanTheCommands) {
  LateBase base(0.3, 0.2);
  CommandLag lag;
  double off_by_lag_m = 0.0;
  double off_by_command_m = 0.0;
  for (int i = 0; i < 120; ++i) {
    const Twist done = lag.next(motion_of(commanded(i)));
    const Pose2 seen = base.drive(commanded(i));
    if (i < 80) {
      lag.learn(seen);
    } else {
      off_by_lag_m += std::abs(done.linear_m_s * kSampleS - seen.x);
      off_by_command_m += std::abs(commanded(i).linear_m_s * kSampleS - seen.x);
    }
  }
  EXPECT_LT(off_by_lag_m, 0.2 * off_by_command_m);
}

TEST(CommandLag, ABaseThatObeysAtOnceIsTakenForOneUntilStepsTellOtherwise) {
  CommandLag lag;
  const Twist done = lag.next(motion_of({0.4, 0.2}));
  EXPECT_DOUBLE_EQ(done.linear_m_s, 0.4);
  EXPECT_DOUBLE_EQ(done.angular_rad_s, 0.2);
  EXPECT_EQ(lag.delay_s(), 0.0);
  EXPECT_EQ(lag.time_constant_s(), 0.0);
}

}  // namespace
}  // namespace weft::agents
