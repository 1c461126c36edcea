#include "core/network/registrations.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/names.hpp"
#include "core/text.hpp"

namespace weft {
namespace {

/// Bounds the names in a sentence, which has to fit into a message.
constexpr std::size_t kPicksSaid = 10;

Result<void> check_pick(const Snapshot& snapshot, const std::string& plan, const Pick& pick) {
  if (!parse_place_id(pick.name)) {
    if (const Result<void> good = check_name("pick", pick.name); !good)
      return fail(good.error().code, "plan " + plan + ", " + good.error().message);
  }
  const std::string name = "plan " + plan + ", pick " + pick.name;
  if (!is_on_plan(pick.in_place) || !is_on_plan(pick.on_plan)) {
    return fail(ErrorCode::invalid, name + ": a point lies farther than " + short_number(kPlanReach_m) +
                                        " m from its origin; give metres, not pixels or degrees");
  }
  if (!(pick.sigma_m >= kLeastPickSigma_m && pick.sigma_m <= kMostPickSigma_m)) {
    return fail(ErrorCode::invalid, name + ": its sigma is " + short_number(pick.sigma_m) + " m; it must be from " +
                                        short_number(kLeastPickSigma_m) + " to " + short_number(kMostPickSigma_m) +
                                        " m");
  }
  if (pick.heading && !std::isfinite(*pick.heading)) {
    return fail(ErrorCode::invalid, name + ": its heading is no number; give radians, or none");
  }
  if (snapshot.place(pick.place) != nullptr) return {};
  return fail(ErrorCode::not_found,
              name + ": place " + to_string(pick.place) + " is not in the map; weft map export lists its places");
}

Snapshot one_on(const Snapshot& snapshot, Snapshot::Registrations registrations) {
  return {{snapshot.revision().value + 1}, snapshot.experiences(),
          snapshot.shared_labels(),        snapshot.shared_aparts(),
          snapshot.shared_rules(),         std::make_shared<const Snapshot::Registrations>(std::move(registrations))};
}

}  // namespace

Result<void> check(const Snapshot& snapshot, const Registration& registration) {
  if (const Result<void> good = check_name("plan", registration.plan); !good) return good;
  const std::string name = "plan " + registration.plan;
  const std::size_t count = registration.picks.size();
  if (count == 0 || count > kMostPicks) {
    return fail(ErrorCode::invalid,
                name + " has " + std::to_string(count) + " picks; give from 1 to " + std::to_string(kMostPicks));
  }
  for (const Pick& pick : registration.picks) {
    if (const Result<void> good = check_pick(snapshot, registration.plan, pick); !good) return good;
  }
  const Snapshot::Registrations& known = snapshot.registrations();
  if (known.contains(registration.plan) || known.size() < kMostRegistrations) return {};
  return fail(ErrorCode::invalid,
              name + ": the map has " + std::to_string(kMostRegistrations) +
                  " registered plans, which is the most; remove one (weft map register --remove)");
}

bool is_on_plan(const Eigen::Vector2d& point) {
  return std::abs(point.x()) <= kPlanReach_m && std::abs(point.y()) <= kPlanReach_m;  // no number is not within
}

std::string to_string(const Registration& registration) {
  const std::size_t count = registration.picks.size();
  std::string text = "plan " + registration.plan + " by " + std::to_string(count) + (count == 1 ? " pick" : " picks");
  for (std::size_t at = 0; at < std::min(count, kPicksSaid); ++at) {
    text += (at == 0 ? ": " : ", ") + registration.picks[at].name;
  }
  return count > kPicksSaid ? text + " ..." : text;
}

Snapshot with_registration(const Snapshot& snapshot, const Registration& registration) {
  Snapshot::Registrations registrations = snapshot.registrations();
  registrations.insert_or_assign(registration.plan, registration);
  return one_on(snapshot, std::move(registrations));
}

Snapshot without_registration(const Snapshot& snapshot, const std::string& plan) {
  Snapshot::Registrations registrations = snapshot.registrations();
  registrations.erase(plan);
  return one_on(snapshot, std::move(registrations));
}

}  // namespace weft
