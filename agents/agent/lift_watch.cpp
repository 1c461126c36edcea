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
constexpr std::size_t kMostExperiences = 256;  // that it remembers itself on

struct Bounds {
  double noticed_m = 0.0;
  double forgotten_m = 0.0;
};
constexpr Bounds kAgainstPlaces{0.007, 0.005};
constexpr Bounds kAgainstItself{0.005, 0.003};

bool is_beyond(const std::optional<double>& lift_m, const Bounds& bounds, bool noticed) {
  return lift_m.has_value() && std::abs(*lift_m) >= (noticed ? bounds.forgotten_m : bounds.noticed_m);
}

std::string words_for(double lift_m, const char* against) {
  return "its camera stands " + std::to_string(std::lround(1000.0 * std::abs(lift_m))) + " mm " +
         (lift_m < 0.0 ? "lower" : "higher") + " than " + against +
         ": look at load, tyres and mount, or calibrate it (weft calibrate mount)";
}

void push(std::deque<double>& newest, double value) {
  newest.push_back(value);
  if (newest.size() > kKept) newest.pop_front();
}
}  // namespace

void LiftWatch::add(const ExperienceId& experience, double lift_m) {
  push(newest_, lift_m);
  note_change(experience, lift_m);
  look();
}

void LiftWatch::note_change(const ExperienceId& experience, double lift_m) {
  if (before_.size() >= kMostExperiences && !before_.contains(experience)) before_.clear();
  std::deque<double>& before = before_[experience];
  if (before.size() < kKept) {
    before.push_back(lift_m);
  } else {
    push(changes_, lift_m - *median_of(before));
  }
}

void LiftWatch::look() {
  off_places_ = is_beyond(lift_m(), kAgainstPlaces, off_places_);
  has_changed_ = is_beyond(change_m(), kAgainstItself, has_changed_);
  notice_.clear();
  if (off_places_) {
    notice_ = words_for(*lift_m(), "its places say");
  } else if (has_changed_) {
    notice_ = words_for(*change_m(), "when it came here before");
  }
}

std::optional<double> LiftWatch::median_of(const std::deque<double>& newest) {
  if (newest.size() < kFewest) return std::nullopt;
  std::vector<double> sorted(newest.begin(), newest.end());
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
