#include "server/eta/speeds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace weft::server {
namespace {

constexpr std::size_t kLatestKept = 200;
/// Bounds what counts as much as all passes of a piece do together: waits are rare and long.
constexpr double kEnough_m = 20.0;

/// Adds the pass to the last of them while that is a short one.
template <class Passes>
void add_to(Passes& passes, const Pass& pass, std::size_t most) {
  if (passes.empty() || passes.back().length_m >= Speeds::kShortPass_m) {
    if (passes.size() == most) passes.erase(passes.begin());
    passes.push_back(pass);
    return;
  }
  passes.back().length_m += pass.length_m;
  passes.back().drive_s += pass.drive_s;
  passes.back().wait_s += pass.wait_s;
}

template <class Passes>
std::optional<double> median_speed_m_s(const Passes& passes) {
  std::vector<double> speeds;
  for (const Pass& pass : passes) {
    if (pass.length_m >= Speeds::kShortPass_m && pass.drive_s > 0.0) speeds.push_back(pass.length_m / pass.drive_s);
  }
  if (speeds.empty()) return std::nullopt;
  return quantile(std::move(speeds), 0.5);
}

template <class Passes>
Pass sum_of(const Passes& passes) {
  Pass sum;
  for (const Pass& pass : passes) {
    sum.length_m += pass.length_m;
    sum.wait_s += pass.wait_s;
  }
  return sum;
}

/// Returns the lowest limit of the hop that begins at that index; none: there is none.
std::optional<double> limit_m_s(const Route& route, std::size_t hop) {
  std::optional<double> lowest;
  for (const SpeedLimit& limit : route.limits) {
    if (limit.from > hop) break;
    if (limit.to >= hop && (!lowest || limit.limit_m_s < *lowest)) lowest = limit.limit_m_s;
  }
  return lowest;
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  const auto last = static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::llround(share * last));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

Speeds::Speeds(const std::map<RunPiece, std::vector<Pass>>& stored) {
  for (const auto& [piece, passes] : stored) {
    Known& known = known_[piece];
    known.passes = passes;
    sum_up(known);
    if (latest_.size() < kLatestKept && !passes.empty()) latest_.push_back(passes.back());
  }
}

void Speeds::sum_up(Known& known) {
  known.speed_m_s = median_speed_m_s(known.passes);
  known.sum = sum_of(known.passes);
}

void Speeds::add(const RunPiece& piece, const Pass& pass) {
  Known& known = known_[piece];
  add_to(known.passes, pass, kPassesKept);
  sum_up(known);
  add_to(latest_, pass, kLatestKept);
  unsaved_.insert(piece);
}

Pace Speeds::everywhere() const {
  const Pass sum = sum_of(latest_);
  return {.speed_m_s = median_speed_m_s(latest_).value_or(kDefaultSpeed_m_s),
          .wait_s_per_m = sum.length_m > 0.0 ? sum.wait_s / sum.length_m : 0.0};
}

Pace Speeds::pace(const RunPiece& piece, const Pace& everywhere) const {
  const auto found = known_.find(piece);
  if (found == known_.end()) return everywhere;
  const Pass& sum = found->second.sum;
  return {.speed_m_s = found->second.speed_m_s.value_or(everywhere.speed_m_s),
          .wait_s_per_m = (sum.wait_s + everywhere.wait_s_per_m * kEnough_m) / (sum.length_m + kEnough_m)};
}

Pace Speeds::pace(const RunPiece& piece) const {
  return pace(piece, everywhere());
}

TimeLeft Speeds::left(const Route& route, std::size_t at) const {
  TimeLeft left;
  const Pace all = everywhere();
  std::optional<RunPiece> piece;
  Pace pace;
  for (std::size_t hop = at; hop + 1 < route.places.size(); ++hop) {
    const RunPiece next = piece_of(route.places[hop], route.places[hop + 1]);
    if (piece != next) {
      piece = next;
      pace = this->pace(next, all);
    }
    const double length_m = distance_m(route.relations[hop]);
    left.drive_s += length_m / std::min(pace.speed_m_s, limit_m_s(route, hop).value_or(pace.speed_m_s));
    left.wait_s += length_m * pace.wait_s_per_m;
  }
  return left;
}

std::vector<storage::PutPasses> Speeds::take_unsaved(std::size_t most) {
  std::vector<storage::PutPasses> taken;
  while (taken.size() < most && !unsaved_.empty()) {
    const RunPiece piece = *unsaved_.begin();
    unsaved_.erase(unsaved_.begin());
    taken.push_back({piece, known_.at(piece).passes});
  }
  return taken;
}

void Speeds::put_back(const std::vector<storage::PutPasses>& passes) {
  for (const storage::PutPasses& put : passes) unsaved_.insert(put.piece);
}

}  // namespace weft::server
