#include "server/dispatcher/charge.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/text.hpp"

namespace weft::server {
namespace {

Error out_of_order(const char* name, double share, const std::string& bound) {
  return {ErrorCode::invalid,
          std::string("charge_") + name + "_percent is " + short_number(100.0 * share) + "; it must be " + bound};
}

}  // namespace

Result<void> check(const ChargeLevels& levels) {
  const auto is_share = [](double share) { return share >= 0.0 && share <= 1.0; };
  if (!is_share(levels.critical)) return fail(out_of_order("critical", levels.critical, "from 0 to 100"));
  if (!is_share(levels.low) || levels.low < levels.critical)
    return fail(out_of_order("low", levels.low, "from charge_critical_percent to 100"));
  if (!is_share(levels.enough) || levels.enough <= levels.low)
    return fail(out_of_order("enough", levels.enough, "over charge_low_percent, and at most 100"));
  if (!is_share(levels.full) || levels.full < levels.enough)
    return fail(out_of_order("full", levels.full, "from charge_enough_percent to 100"));
  if (levels.range_m >= 1.0 && levels.range_m <= 1e6) return {};
  return fail(ErrorCode::invalid, "charge_range_m is " + short_number(levels.range_m) +
                                      "; it must be from 1 to 1000000: how far a full battery drives");
}

double share_for(const ChargeLevels& levels, double way_m) {
  return way_m / levels.range_m + kChargeReserve;
}

const ChargeWatch::Known* ChargeWatch::find(const RobotId& robot) const {
  const auto found = robots_.find(robot);
  return found == robots_.end() ? nullptr : &found->second;
}

void ChargeWatch::take(const RobotId& robot, double share, bool is_charging, SteadyTime now) {
  Known& known = robots_[robot];
  known.share = share;
  if (share >= levels_.enough) {
    known.is_recharging = false;
    known.wants_since.reset();
    return;
  }
  known.is_recharging = known.is_recharging || is_charging || share <= levels_.critical;
  const bool wants = known.is_recharging || share <= levels_.low;
  if (wants && !known.wants_since) known.wants_since = now;
}

void ChargeWatch::fell_short(const RobotId& robot, SteadyTime now) {
  const auto found = robots_.find(robot);
  if (found != robots_.end() && !found->second.wants_since) found->second.wants_since = now;
}

void ChargeWatch::sent(const RobotId& robot) {
  const auto found = robots_.find(robot);
  if (found != robots_.end()) found->second.is_recharging = found->second.share < levels_.enough;
}

std::optional<int> ChargeWatch::percent(const RobotId& robot) const {
  const Known* const known = find(robot);
  if (known == nullptr) return std::nullopt;
  constexpr double kRounding = 1e-9;  // 0.29 is 29 %
  return static_cast<int>(std::floor(100.0 * known->share + kRounding));
}

bool ChargeWatch::is_recharging(const RobotId& robot) const {
  const Known* const known = find(robot);
  return known != nullptr && known->is_recharging;
}

bool ChargeWatch::is_critical(const RobotId& robot) const {
  const Known* const known = find(robot);
  return known != nullptr && known->share <= levels_.critical;
}

bool ChargeWatch::is_full(const RobotId& robot) const {
  const Known* const known = find(robot);
  return known == nullptr || known->share >= levels_.full;
}

std::vector<RobotId> ChargeWatch::queue() const {
  std::vector<std::tuple<bool, SteadyTime, RobotId>> turns;
  for (const auto& [robot, known] : robots_) {
    if (known.wants_since) turns.emplace_back(known.share > levels_.critical, *known.wants_since, robot);
  }
  std::ranges::sort(turns);
  std::vector<RobotId> queue;
  queue.reserve(turns.size());
  for (const auto& [is_less_urgent, since, robot] : turns) queue.push_back(robot);
  return queue;
}

}  // namespace weft::server
