#include "core/network/site_frame.hpp"

#include <algorithm>
#include <cmath>

namespace weft {
namespace {

constexpr double kContradicts = 4.0;  // sigma
constexpr std::size_t kFewestToJudge = 4;

Eigen::Vector2d in_layout(const SitePick& pick) {
  return pick.layout_from_place * pick.in_place;
}
double weight_of(const SitePick& pick) {
  return 1.0 / (pick.sigma_m * pick.sigma_m);
}

using Chosen = std::vector<const SitePick*>;

/// Holds the picks' weighted middles, and the sums that say how one cloud turns and stretches into the other.
struct Moments {
  Eigen::Vector2d layout = Eigen::Vector2d::Zero();
  Eigen::Vector2d plan = Eigen::Vector2d::Zero();
  double weight = 0.0;
  double cosine = 0.0;
  double sine = 0.0;
  double spread = 0.0;  ///< of the layout: weighted sum of squares
};

Moments moments_of(const Chosen& picks) {
  Moments m;
  for (const SitePick* pick : picks) m.weight += weight_of(*pick);
  for (const SitePick* pick : picks) {
    m.layout += weight_of(*pick) / m.weight * in_layout(*pick);
    m.plan += weight_of(*pick) / m.weight * pick->on_plan;
  }
  for (const SitePick* pick : picks) {
    const Eigen::Vector2d from = in_layout(*pick) - m.layout;
    const Eigen::Vector2d to = pick->on_plan - m.plan;
    m.cosine += weight_of(*pick) * from.dot(to);
    m.sine += weight_of(*pick) * (from.x() * to.y() - from.y() * to.x());
    m.spread += weight_of(*pick) * from.squaredNorm();
  }
  return m;
}

Pose2 fit(const Chosen& picks) {
  const Moments m = moments_of(picks);
  const Pose2 turned{0.0, 0.0, std::atan2(m.sine, m.cosine)};
  const Eigen::Vector2d moved = m.plan - turned * m.layout;
  return {moved.x(), moved.y(), turned.heading};
}

double off(const Pose2& plan_from_layout, const SitePick& pick) {
  return (plan_from_layout * in_layout(pick) - pick.on_plan).norm();
}

/// Returns how far the points lie from where they were picked, each way; three degrees of freedom were fitted.
double spread_of(const Pose2& plan_from_layout, const Chosen& picks) {
  if (picks.size() < 2) return 0.0;
  double sum = 0.0;
  for (const SitePick* pick : picks) sum += std::pow(off(plan_from_layout, *pick), 2);
  const auto free = static_cast<double>(2 * picks.size() - 3);
  return std::sqrt(sum / free);
}

bool lie_apart(const std::vector<SitePick>& picks) {
  for (const SitePick& a : picks) {
    const auto is_apart = [&](const SitePick& b) {
      return (in_layout(a) - in_layout(b)).norm() >= kPicksApart_m && (a.on_plan - b.on_plan).norm() >= kPicksApart_m;
    };
    if (std::any_of(picks.begin(), picks.end(), is_apart)) return true;
  }
  return false;
}

/// Returns how surely the picks foretell where another one lies: what they leave of the position, and of the heading
/// at its distance from their middle.
double sigma_of_foretold(const Pose2& plan_from_layout, const Chosen& picks, const SitePick& another) {
  const Moments m = moments_of(picks);
  const double spread = spread_of(plan_from_layout, picks);
  const double grown = std::max(1.0, spread * std::sqrt(m.weight / static_cast<double>(picks.size())));
  const double away = (in_layout(another) - m.layout).squaredNorm();
  const double turned = m.spread > 0.0 ? away / m.spread : 0.0;
  return std::hypot(another.sigma_m, spread, grown * std::sqrt(1.0 / m.weight + turned));
}

/// Returns the index in `chosen` of the pick that contradicts the others most; none: none does.
std::optional<std::size_t> contradicting(const Chosen& chosen) {
  std::optional<std::size_t> worst;
  double most = kContradicts;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    Chosen others = chosen;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Pose2 without = fit(others);
    const double sigmas = off(without, *chosen[i]) / sigma_of_foretold(without, others, *chosen[i]);
    if (sigmas <= most) continue;
    most = sigmas;
    worst = i;
  }
  return worst;
}

/// Returns the frame by the headings of picks that lie too near to one another to tell it by their positions; none:
/// no pick has a heading.
std::optional<SiteFrame> held_by_headings(const std::vector<SitePick>& picks) {
  double sine = 0.0;
  double cosine = 0.0;
  Chosen chosen;
  for (const SitePick& pick : picks) {
    chosen.push_back(&pick);
    if (!pick.heading) continue;
    sine += std::sin(*pick.heading - pick.layout_from_place.heading);
    cosine += std::cos(*pick.heading - pick.layout_from_place.heading);
  }
  if (sine == 0.0 && cosine == 0.0) return std::nullopt;
  const Moments m = moments_of(chosen);
  const Pose2 turned{0.0, 0.0, std::atan2(sine, cosine)};
  const Eigen::Vector2d moved = m.plan - turned * m.layout;
  SiteFrame frame;
  frame.plan_from_layout = {moved.x(), moved.y(), turned.heading};
  for (const SitePick& pick : picks) frame.off_m.push_back(off(frame.plan_from_layout, pick));
  frame.sigma_m = 1.0 / std::sqrt(m.weight);
  return frame;
}

}  // namespace

Result<SiteFrame> fit_site_frame(const std::vector<SitePick>& picks) {
  if (picks.empty()) return fail(ErrorCode::invalid, "nothing is picked on the plan: pick two places or more");
  for (const SitePick& pick : picks) {
    if (!(pick.sigma_m >= 0.001 && pick.sigma_m <= 10.0))
      return fail(ErrorCode::invalid, "pick " + pick.name + ": its sigma must be from 0.001 to 10 m");
  }
  if (!lie_apart(picks)) {
    if (const std::optional<SiteFrame> frame = held_by_headings(picks)) return *frame;
    if (picks.size() > 1)
      return fail(ErrorCode::invalid, "the picks lie within 1 m of one another: pick places that lie further apart");
    return fail(ErrorCode::invalid, "one pick needs a heading: " + picks.front().name +
                                        "=X,Y,HEADING; or pick a second place at least 1 m away");
  }

  Chosen chosen;
  for (const SitePick& pick : picks) chosen.push_back(&pick);
  SiteFrame frame;
  while (chosen.size() >= kFewestToJudge) {
    const std::optional<std::size_t> worst = contradicting(chosen);
    if (!worst) break;
    frame.left_out.push_back(static_cast<std::size_t>(chosen[*worst] - picks.data()));
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(*worst));
  }
  frame.plan_from_layout = fit(chosen);
  const Moments m = moments_of(chosen);
  if (m.spread > 0.0) frame.scale = std::hypot(m.cosine, m.sine) / m.spread;
  for (const SitePick& pick : picks) frame.off_m.push_back(off(frame.plan_from_layout, pick));
  // Scatter beyond the stated sigmas comes from the layout.
  const double stated = std::sqrt(static_cast<double>(chosen.size()) / m.weight);
  const double grown = std::max(1.0, spread_of(frame.plan_from_layout, chosen) / stated);
  frame.sigma_m = grown / std::sqrt(m.weight);
  if (m.spread > 0.0) frame.sigma_rad = grown / std::sqrt(m.spread);
  return frame;
}

}  // namespace weft
