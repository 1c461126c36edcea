#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/perception/sample.hpp"

namespace weft::agents {

/// Describes the battery of a simulated body, and where the simulation lets it charge: a body knows no map.
struct BatterySetup {
  double share = 1.0;  ///< of full, when the body's time begins
  double drains_per_m = 0.0002;
  double drains_per_s = 0.000005;
  double charges_per_s = 0.0005;
  std::vector<SitePoint> chargers{};
  double reach_m = 0.5;  ///< from a charger, at which a body that stands is charged
};

/// Drains while the body is on, and fills while it stands at a charger.
class Battery {
 public:
  explicit Battery(BatterySetup setup) : setup_(std::move(setup)), share_(setup_.share) {}

  /// Takes what the body has driven, in how long, and where it is then.
  void advance(double driven_m, double elapsed_s, const SitePoint& at) {
    constexpr double stands_below_m_s = 0.005;
    const bool stands = std::abs(driven_m) <= stands_below_m_s * elapsed_s;
    is_charging_ = stands && is_at_charger(at);
    const double change = is_charging_ ? setup_.charges_per_s * elapsed_s
                                       : -setup_.drains_per_s * elapsed_s - setup_.drains_per_m * std::abs(driven_m);
    share_ = std::clamp(share_ + change, 0.0, 1.0);
  }
  bool is_empty() const { return share_ <= 0.0; }
  Charge charge() const {
    const bool is_known = is_charging_ && setup_.charges_per_s > 0.0;
    return {.share = share_,
            .is_charging = is_charging_,
            .minutes = is_known ? std::optional((1.0 - share_) / setup_.charges_per_s / 60.0) : std::nullopt};
  }

 private:
  bool is_at_charger(const SitePoint& at) const {
    return std::ranges::any_of(setup_.chargers, [&](const SitePoint& charger) {
      return std::hypot(charger.x - at.x, charger.y - at.y) <= setup_.reach_m;
    });
  }

  BatterySetup setup_;
  double share_;
  bool is_charging_ = false;
};

}  // namespace weft::agents
