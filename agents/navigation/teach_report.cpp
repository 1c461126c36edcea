#include "agents/navigation/teach_report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace weft::agents {
namespace {

using Reasons = std::map<std::string_view, int>;

/// Holds one stretch while it is added up.
struct Tally {
  std::vector<const TaughtPlace*> places;
  int tried = 0;
  std::vector<int> found;  ///< by condition
  std::vector<Reasons> refused;
  double sigma_m = 0.0;
  std::string_view missed;

  bool says_something() const { return tried > 0 || (places.empty() && !missed.empty()); }
};

void add(const TaughtPlace& place, Tally& tally) {
  tally.places.push_back(&place);
  if (!place.trials) return;
  ++tally.tried;
  for (std::size_t i = 0; i < place.trials->size() && i < tally.found.size(); ++i) {
    const Trial& trial = (*place.trials)[i];
    if (trial.found) {
      ++tally.found[i];
    } else {
      ++tally.refused[i][trial.refused];
    }
  }
  const Trial& as_is = place.trials->front();
  if (as_is.found) tally.sigma_m += as_is.sigma_m;
}

/// Returns "half light: few_inliers".
std::string in_words(std::string_view condition, std::string_view refusal) {
  std::string words(condition);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words + ": " + std::string(refusal);
}

/// Returns the worst condition and its most frequent refusal; of a tie the mildest condition.
std::string reason_of(const Tally& tally, const std::vector<std::string_view>& conditions) {
  const auto worst =
      static_cast<std::size_t>(std::min_element(tally.found.begin(), tally.found.end()) - tally.found.begin());
  const Reasons& reasons = tally.refused[worst];
  if (reasons.empty()) return {};
  const auto rarer = [](const auto& a, const auto& b) { return a.second < b.second; };
  return in_words(conditions[worst], std::max_element(reasons.begin(), reasons.end(), rarer)->first);
}

/// Returns the share of places found, its standard error being a binomial's.
Diagnostic share_of(std::string_view condition, int found, int tried) {
  const double share = tried > 0 ? static_cast<double>(found) / tried : 0.0;
  const double sigma = tried > 0 ? std::sqrt(share * (1.0 - share) / tried) : 0.0;
  return {std::string(condition), share, sigma, kFoundEnough};
}

TaughtStretch row_of(const Tally& tally, const std::vector<std::string_view>& conditions, double from_m, double to_m,
                     const PlaceId& before) {
  TaughtStretch row;
  row.from_m = from_m;
  row.to_m = to_m;
  row.places = static_cast<std::uint32_t>(tally.places.size());
  row.first = tally.places.empty() ? before : tally.places.front()->id;
  for (std::size_t i = 0; i < conditions.size(); ++i)
    row.found.push_back(share_of(conditions[i], tally.found[i], tally.tried));
  if (tally.tried == 0) {
    row.reason = "no place: " + std::string(tally.missed);
    return row;
  }
  if (tally.found[0] > 0) row.sigma_m = tally.sigma_m / tally.found[0];
  row.reason = reason_of(tally, conditions);
  return row;
}

/// Adds what share of the row's metres was seen. Where that is the worst, the row says why.
void add_seen(const std::vector<BlindStretch>& blind, TaughtStretch& row) {
  double blind_m = 0.0;
  std::map<std::string_view, double> reasons;
  for (const BlindStretch& stretch : blind) {
    const double within_m = std::min(stretch.to_m, row.to_m) - std::max(stretch.from_m, row.from_m);
    if (within_m <= 0.0) continue;
    blind_m += within_m;
    reasons[stretch.reason] += within_m;
  }
  const double length_m = row.to_m - row.from_m;
  const double seen = length_m > 0.0 ? std::clamp(1.0 - blind_m / length_m, 0.0, 1.0) : 1.0;
  const bool is_worst =
      std::ranges::all_of(row.found, [seen](const Diagnostic& share) { return seen < share.value; });
  row.found.push_back({std::string(kSeenShare), seen, 0.0, kFoundEnough});
  if (reasons.empty() || !is_worst) return;
  const auto shorter = [](const auto& a, const auto& b) { return a.second < b.second; };
  row.reason = in_words(kSeenShare, std::max_element(reasons.begin(), reasons.end(), shorter)->first);
}

}  // namespace

std::vector<TaughtStretch> stretches_of(const TeachReport& report, std::size_t most) {
  if (report.places.empty() || report.conditions.empty() || most == 0) return {};
  const double metres = std::max(report.driven_m, report.places.back().at_m);
  const double length_m = std::max(1.0, std::ceil(metres / static_cast<double>(most)));
  // What is left at the end counts to the last row unless it is half a row itself.
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(metres / length_m)));
  Tally none;
  none.found.resize(report.conditions.size());
  none.refused.resize(report.conditions.size());
  std::vector<Tally> tallies(std::min(count, most), none);
  const auto tally_at = [&](double at_m) -> Tally& {
    return tallies[std::min(static_cast<std::size_t>(std::max(0.0, at_m) / length_m), tallies.size() - 1)];
  };
  for (const Missed& missed : report.missed) tally_at(missed.at_m).missed = missed.reason;
  for (const TaughtPlace& place : report.places) add(place, tally_at(place.at_m));

  std::vector<TaughtStretch> rows;
  PlaceId before = report.places.front().id;
  std::uint32_t untried = 0;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const double to_m = i + 1 < tallies.size() ? length_m * static_cast<double>(i + 1) : metres;
    if (tallies[i].says_something()) {
      if (!rows.empty()) rows.back().places += untried;
      untried = 0;
      rows.push_back(row_of(tallies[i], report.conditions, length_m * static_cast<double>(i), to_m, before));
    } else {
      untried += static_cast<std::uint32_t>(tallies[i].places.size());
    }
    if (!tallies[i].places.empty()) before = tallies[i].places.back()->id;
  }
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) rows[i].to_m = rows[i + 1].from_m;
  for (TaughtStretch& row : rows) add_seen(report.blind, row);
  return rows;
}

}  // namespace weft::agents
