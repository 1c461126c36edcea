#include "core/network/site_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace weft {
namespace {

constexpr double kContradicts = 4.0;  // sigma
constexpr std::size_t kFewestToJudge = 4;

/// Holds a pick with what the fits need of it, worked out once: of many picks there are many fits.
struct Point {
  const SitePick* pick = nullptr;
  Eigen::Vector2d in_layout = Eigen::Vector2d::Zero();
  double weight = 0.0;
};
using Chosen = std::vector<Point>;

Chosen points_of(const std::vector<SitePick>& picks) {
  Chosen points;
  for (const SitePick& pick : picks) {
    points.push_back({&pick, pick.layout_from_place * pick.in_place, 1.0 / (pick.sigma_m * pick.sigma_m)});
  }
  return points;
}

/// Holds the picks' weighted middles, and the sums that say how one cloud turns and stretches into the other.
struct Moments {
  Eigen::Vector2d layout = Eigen::Vector2d::Zero();
  Eigen::Vector2d plan = Eigen::Vector2d::Zero();
  double weight = 0.0;
  double cosine = 0.0;
  double sine = 0.0;
  double spread = 0.0;  ///< of the layout: weighted sum of squares
};

Moments moments_of(const Chosen& points) {
  Moments m;
  for (const Point& point : points) m.weight += point.weight;
  for (const Point& point : points) {
    m.layout += point.weight / m.weight * point.in_layout;
    m.plan += point.weight / m.weight * point.pick->on_plan;
  }
  for (const Point& point : points) {
    const Eigen::Vector2d from = point.in_layout - m.layout;
    const Eigen::Vector2d to = point.pick->on_plan - m.plan;
    m.cosine += point.weight * from.dot(to);
    m.sine += point.weight * (from.x() * to.y() - from.y() * to.x());
    m.spread += point.weight * from.squaredNorm();
  }
  return m;
}

/// Returns the turn by so many radians that leaves the picks' middles upon one another.
Pose2 turned_about_middle(const Moments& m, double heading) {
  const Eigen::Vector2d moved = m.plan - Pose2{0.0, 0.0, heading} * m.layout;
  return {moved.x(), moved.y(), heading};
}

Pose2 fit(const Moments& m) {
  return turned_about_middle(m, std::atan2(m.sine, m.cosine));
}

/// Returns by how much the plan's point differs from where the frame puts each pick.
std::vector<double> all_off(const Pose2& plan_from_layout, const Chosen& points) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(plan_from_layout.heading).toRotationMatrix();
  const Eigen::Vector2d moved = plan_from_layout.translation();
  std::vector<double> off_m;
  off_m.reserve(points.size());
  for (const Point& point : points) off_m.push_back((turn * point.in_layout + moved - point.pick->on_plan).norm());
  return off_m;
}

/// Returns how far the points lie from where they were picked, each way; three degrees of freedom were fitted.
double spread_of(const std::vector<double>& off_m) {
  if (off_m.size() < 2) return 0.0;
  double sum = 0.0;
  for (const double off : off_m) sum += off * off;
  return std::sqrt(sum / static_cast<double>(2 * off_m.size() - 3));
}

/// Describes the two picks that come nearest to lying `kPicksApart_m` apart both in the layout and on the plan.
struct Farthest {
  std::size_t a = 0;
  std::size_t b = 0;
  double in_layout_m = 0.0;
  double on_plan_m = 0.0;
  double apart_m() const { return std::min(in_layout_m, on_plan_m); }
};

Farthest farthest_of(const Chosen& points) {
  Farthest farthest;
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = a + 1; b < points.size(); ++b) {
      const Farthest pair{a, b, (points[a].in_layout - points[b].in_layout).norm(),
                          (points[a].pick->on_plan - points[b].pick->on_plan).norm()};
      if (farthest.b == 0 || pair.apart_m() > farthest.apart_m()) farthest = pair;
    }
  }
  return farthest;
}

tl::unexpected<Error> too_near(const std::vector<SitePick>& picks, const Farthest& pair) {
  const bool is_one_spot = pair.in_layout_m == 0.0;
  return fail(
      ErrorCode::invalid,
      "no two picks lie " + short_number(kPicksApart_m) + " m apart both in the map and on the plan; " +
          picks[pair.a].name + " and " + picks[pair.b].name + " come nearest to it: they lie " +
          (is_one_spot ? "at one spot of the map" : fixed_number(pair.in_layout_m, 2) + " m apart in the map") +
          " and " + fixed_number(pair.on_plan_m, 2) + " m apart on the plan; pick places that lie further apart");
}

/// Returns how surely the picks foretell where another one lies: what they leave of the position, and of the heading
/// at its distance from their middle.
double sigma_of_foretold(const Moments& m, const std::vector<double>& off_m, const Point& another) {
  const double spread = spread_of(off_m);
  const double grown = std::max(1.0, spread * std::sqrt(m.weight / static_cast<double>(off_m.size())));
  const double away = (another.in_layout - m.layout).squaredNorm();
  const double turned = m.spread > 0.0 ? away / m.spread : 0.0;
  return std::hypot(another.pick->sigma_m, spread, grown * std::sqrt(1.0 / m.weight + turned));
}

/// Returns the index in `chosen` of the pick that contradicts the others most; none: none does.
std::optional<std::size_t> contradicting(const Chosen& chosen) {
  std::optional<std::size_t> worst;
  double most = kContradicts;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    Chosen others = chosen;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Moments m = moments_of(others);
    const Pose2 without = fit(m);
    const double off_m = all_off(without, {chosen[i]}).front();
    const double sigmas = off_m / sigma_of_foretold(m, all_off(without, others), chosen[i]);
    if (sigmas <= most) continue;
    most = sigmas;
    worst = i;
  }
  return worst;
}

/// Returns the frame by the headings of picks that lie too near to one another to tell it by their positions; none:
/// no pick has a heading.
std::optional<SiteFrame> held_by_headings(const Chosen& points) {
  double sine = 0.0;
  double cosine = 0.0;
  for (const Point& point : points) {
    if (!point.pick->heading) continue;
    sine += std::sin(*point.pick->heading - point.pick->layout_from_place.heading);
    cosine += std::cos(*point.pick->heading - point.pick->layout_from_place.heading);
  }
  if (sine == 0.0 && cosine == 0.0) return std::nullopt;
  const Moments m = moments_of(points);
  SiteFrame frame;
  frame.plan_from_layout = turned_about_middle(m, std::atan2(sine, cosine));
  frame.off_m = all_off(frame.plan_from_layout, points);
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
  const Chosen all = points_of(picks);
  if (const Farthest farthest = farthest_of(all); !(farthest.apart_m() >= kPicksApart_m)) {
    if (const std::optional<SiteFrame> frame = held_by_headings(all)) return *frame;
    if (picks.size() > 1) return too_near(picks, farthest);
    return fail(ErrorCode::invalid, "one pick needs a heading: " + picks.front().name +
                                        "=X,Y,HEADING; or pick a second place at least 1 m away");
  }

  Chosen chosen = all;
  SiteFrame frame;
  while (chosen.size() >= kFewestToJudge) {
    const std::optional<std::size_t> worst = contradicting(chosen);
    if (!worst) break;
    frame.left_out.push_back(static_cast<std::size_t>(chosen[*worst].pick - picks.data()));
    chosen.erase(chosen.begin() + static_cast<std::ptrdiff_t>(*worst));
  }
  const Moments m = moments_of(chosen);
  frame.plan_from_layout = fit(m);
  if (m.spread > 0.0) frame.scale = std::hypot(m.cosine, m.sine) / m.spread;
  frame.off_m = all_off(frame.plan_from_layout, all);
  // Scatter beyond the stated sigmas comes from the layout.
  const double stated = std::sqrt(static_cast<double>(chosen.size()) / m.weight);
  const double grown = std::max(1.0, spread_of(all_off(frame.plan_from_layout, chosen)) / stated);
  frame.sigma_m = grown / std::sqrt(m.weight);
  if (m.spread > 0.0) frame.sigma_rad = grown / std::sqrt(m.spread);
  return frame;
}

}  // namespace weft
