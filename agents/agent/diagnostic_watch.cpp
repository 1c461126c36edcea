#include "agents/agent/diagnostic_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace weft::agents {
namespace {
constexpr std::size_t kKept = 15;
constexpr std::size_t kFewest = 8;
constexpr std::size_t kMostExperiences = 256;  // that it remembers itself on

bool is_beyond(const std::optional<double>& value, const WatchedDiagnostic::Bounds& bounds, bool noticed) {
  return value.has_value() && std::abs(*value) >= (noticed ? bounds.ends : bounds.begins);
}

void push(std::deque<double>& newest, double value) {
  newest.push_back(value);
  if (newest.size() > kKept) newest.pop_front();
}
}  // namespace

void DiagnosticWatch::add(const ExperienceId& experience, double value) {
  push(newest_, value);
  note_change(experience, value);
  look();
}

void DiagnosticWatch::note_change(const ExperienceId& experience, double value) {
  if (before_.size() >= kMostExperiences && !before_.contains(experience)) before_.clear();
  std::deque<double>& before = before_[experience];
  if (before.size() < kKept) {
    before.push_back(value);
  } else {
    push(changes_, value - *median_of(before));
  }
}

void DiagnosticWatch::look() {
  off_places_ = is_beyond(value(), what_.against_places, off_places_);
  has_changed_ = is_beyond(change(), what_.against_itself, has_changed_);
  notice_.clear();
  if (off_places_) {
    notice_ = what_.notice(*value(), "its places say");
  } else if (has_changed_) {
    notice_ = what_.notice(*change(), "when it came here before");
  }
}

std::optional<double> DiagnosticWatch::median_of(const std::deque<double>& newest) {
  if (newest.size() < kFewest) return std::nullopt;
  std::vector<double> sorted(newest.begin(), newest.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

DiagnosticWatches::DiagnosticWatches(const std::vector<WatchedDiagnostic>& all) : watches_(all.begin(), all.end()) {}

std::string DiagnosticWatches::add(const Fix& fix) {
  std::string note;
  for (DiagnosticWatch& watch : watches_) {
    const auto& shown = fix.evidence.diagnostics;
    const auto found = std::find_if(shown.begin(), shown.end(),
                                    [&](const Diagnostic& one) { return one.name == watch.what().name; });
    if (found == shown.end()) continue;
    const bool was_well = watch.notice().empty();
    watch.add(fix.place.experience, found->value);
    if (was_well == watch.notice().empty()) continue;
    note = was_well ? watch.notice() : std::string(watch.what().well_again);
  }
  return note;
}

std::string DiagnosticWatches::notice() const {
  for (const DiagnosticWatch& watch : watches_)
    if (!watch.notice().empty()) return watch.notice();
  return {};
}

std::vector<Diagnostic> DiagnosticWatches::all(std::vector<Diagnostic> measured) const {
  for (const DiagnosticWatch& watch : watches_) {
    if (const std::optional<double> value = watch.value())
      measured.push_back({std::string(watch.what().name), *value, 0.0, watch.what().against_places.begins});
  }
  return measured;
}

std::string words_of(const std::vector<Diagnostic>& diagnostics) {
  std::string words;
  for (const Diagnostic& one : diagnostics) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), " %+.2g", one.value);
    words += (words.empty() ? "" : ", ") + one.name + text.data();
    if (one.sigma <= 0.0) continue;
    std::snprintf(text.data(), text.size(), " (one sigma %.1g)", one.sigma);
    words += text.data();
  }
  return words;
}

}  // namespace weft::agents
