#include "agents/agent/lift_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace weft::agents {
namespace {
constexpr std::size_t kKept = 15;
constexpr std::size_t kFewest = 8;
constexpr double kNoticed = 0.007;
constexpr double kForgotten = 0.005;
}  // namespace

void LiftWatch::add(double lift_m) {
  newest_.push_back(lift_m);
  if (newest_.size() > kKept) newest_.pop_front();
  const std::optional<double> lift = this->lift_m();
  if (!lift.has_value()) return;
  if (std::abs(*lift) < (notice_.empty() ? kNoticed : kForgotten)) {
    notice_.clear();
    return;
  }
  notice_ = "its camera stands " + std::to_string(std::lround(1000.0 * std::abs(*lift))) + " mm " +
            (*lift < 0.0 ? "lower" : "higher") +
            " than its places say: look at load, tyres and mount, or calibrate it (weft calibrate mount)";
}

std::optional<double> LiftWatch::lift_m() const {
  if (newest_.size() < kFewest) return std::nullopt;
  std::vector<double> sorted(newest_.begin(), newest_.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

std::string words_of(const MountReport& report, const std::optional<double>& lift_m) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), "off its calibration by pitch %+.2f, roll %+.2f degrees (one sigma %.2f)",
                report.tilt.pitch_rad / kDegree, report.tilt.roll_rad / kDegree, report.tilt.sigma_rad() / kDegree);
  std::string words = text.data();
  if (report.height_by_wheels.has_value()) {
    std::snprintf(text.data(), text.size(), ", height %+.1f %% by the wheels", 100.0 * *report.height_by_wheels);
    words += text.data();
  }
  if (lift_m.has_value()) {
    std::snprintf(text.data(), text.size(), ", height %+.0f mm by stored places", 1000.0 * *lift_m);
    words += text.data();
  }
  const bool unseen = !report.height_by_wheels.has_value() && !lift_m.has_value();
  return unseen ? words + ", height not observable: neither wheels nor stored places" : words;
}

}  // namespace weft::agents
