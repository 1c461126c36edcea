#include "agents/agent/power_reporter.hpp"

#include <algorithm>
#include <chrono>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;
constexpr Duration kBetweenPowerReports = 5s;
}  // namespace

void PowerReporter::take(const std::optional<Charge>& charge, SteadyTime now) {
  const bool is_other = charge && (!charge_ || charge_->is_charging != charge->is_charging);
  charge_ = charge;
  if (is_other) next_ = std::min(next_, now);
}

std::optional<msg::RobotPower> PowerReporter::due(SteadyTime now) {
  if (!charge_ || now < next_) return std::nullopt;
  next_ = now + kBetweenPowerReports;
  return msg::RobotPower{.header = {},
                         .share = std::clamp(charge_->share, 0.0, 1.0),
                         .is_charging = charge_->is_charging,
                         .minutes = charge_->minutes};
}

std::optional<SteadyTime> PowerReporter::next() const {
  return charge_ ? std::optional(next_) : std::nullopt;
}

}  // namespace weft::agents
