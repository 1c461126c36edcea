#include "core/network/site_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/text.hpp"

namespace weft {
namespace {

std::string in_metres(double value) {
  return fixed_number(value, 2) + " m";
}

/// Returns whether all points lie within `kOnOneLine_m` of the line through their middle along which they spread
/// most.
bool lie_on_one_line(const std::vector<SitePick>& picks) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const SitePick& pick : picks) middle += pick.on_plan / static_cast<double>(picks.size());
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const SitePick& pick : picks) {
    const Eigen::Vector2d away = pick.on_plan - middle;
    xx += away.x() * away.x();
    xy += away.x() * away.y();
    yy += away.y() * away.y();
  }
  const double along = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Eigen::Vector2d across{-std::sin(along), std::cos(along)};
  return std::ranges::all_of(
      picks, [&](const SitePick& pick) { return std::abs(across.dot(pick.on_plan - middle)) <= kOnOneLine_m; });
}

/// Returns why the picks that count leave open how the plan lies, or contradict their headings; empty: they do not.
std::string ambiguity(const std::vector<SitePick>& all, const SiteFrame& frame) {
  std::vector<SitePick> picks;
  for (std::size_t at = 0; at < all.size(); ++at) {
    if (std::ranges::count(frame.left_out, at) == 0) picks.push_back(all[at]);
  }
  const bool has_heading = std::ranges::any_of(picks, [](const SitePick& pick) { return pick.heading.has_value(); });
  if (picks.size() >= 3 && !has_heading && lie_on_one_line(picks)) {
    return "all " + std::to_string(picks.size()) + " picks lie within " + short_number(kOnOneLine_m) +
           " m of one line, where a mirrored plan would fit as well: pick a place off that line, or vouch "
           "for it by a heading (LABEL=X,Y,HEADING)";
  }
  for (const SitePick& pick : picks) {
    if (!pick.heading) continue;
    const double found = frame.plan_from_layout.heading + pick.layout_from_place.heading;
    const double off = std::abs(wrap_angle(found - *pick.heading));
    if (off <= kHeadingContradicts) continue;
    return "pick " + pick.name + ": its heading of " + fixed_number(*pick.heading, 2) + " rad contradicts the " +
           fixed_number(wrap_angle(found), 2) + " rad that the positions make, by more than " +
           short_number(kHeadingContradicts) + " rad: give radians, counted from the plan's x towards its y";
  }
  return {};
}

}  // namespace

std::optional<Pose2> SiteSolution::plan_from_place(const PlaceId& place) const {
  const Pose2* const pose = layout_from_place.find(place);
  if (!problem.empty() || pose == nullptr) return std::nullopt;
  return frame.plan_from_layout * *pose;
}

Result<PlaceId> SiteSolution::nearest(const Eigen::Vector2d& on_plan, double most_m) const {
  const std::string name = "plan " + registration.plan;
  if (!problem.empty()) return fail(ErrorCode::refused, name + ": " + problem);
  const Eigen::Vector2d in_layout = frame.plan_from_layout.inverse() * on_plan;
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::pair<PlaceId, Pose2>> found;
  layout_from_place.for_each([&](const PlaceId& place, const Pose2& pose) {
    const double away = (pose.translation() - in_layout).squaredNorm();
    if (!(away < least)) return;
    least = away;
    found.emplace(place, pose);
  });
  if (!found) return fail(ErrorCode::refused, name + ": no place lies on it");
  if (std::sqrt(least) <= most_m) return found->first;
  const Pose2 there = frame.plan_from_layout * found->second;
  return fail(ErrorCode::not_found, name + ": no place lies within " + short_number(most_m) + " m of " +
                                        fixed_number(on_plan.x(), 2) + "," + fixed_number(on_plan.y(), 2) +
                                        "; the nearest is " + to_string(found->first) + ", " +
                                        in_metres(std::sqrt(least)) + " away at " + fixed_number(there.x, 2) + "," +
                                        fixed_number(there.y, 2));
}

std::string to_text(const SiteSolution& solution) {
  if (!solution.problem.empty()) return solution.problem;
  std::size_t fitting = 0;
  double worst_m = 0.0;
  std::string rest;
  for (std::size_t at = 0; at < solution.fits.size(); ++at) {
    const PickFit& fit = solution.fits[at];
    const std::string name = "; " + solution.registration.picks[at].name;
    if (!fit.is_in_map) {
      rest += name + " is no longer in the map";
    } else if (fit.is_left_out) {
      rest += name + " contradicts the others by " + in_metres(fit.off_m) + " and is left out";
    } else {
      ++fitting;
      worst_m = std::max(worst_m, fit.off_m);
    }
  }
  std::string text =
      fitting == 1 ? "held by one pick" : std::to_string(fitting) + " picks fit within " + in_metres(worst_m);
  const double percent = 100.0 * (1.0 / solution.frame.scale - 1.0);
  if (std::abs(percent) >= 0.05)
    text += "; the map is " + fixed_number(std::abs(percent), 1) + " % " + (percent > 0.0 ? "long" : "short");
  return text + rest;
}

SiteSolver::SiteSolver(NetworkView network, Registration registration) {
  solution_.registration = std::move(registration);
  const Pick* first = nullptr;
  for (const Pick& pick : solution_.registration.picks) {
    const bool is_in_map = network.has(pick.place);
    solution_.fits.push_back({.is_in_map = is_in_map});
    if (is_in_map && first == nullptr) first = &pick;
  }
  if (first == nullptr) {
    solution_.problem = "none of its picks is in the map any more: register it again";
  } else {
    layout_.emplace(std::move(network), first->place);
  }
}

bool SiteSolver::step(std::size_t ways) {
  if (!layout_) return false;
  if (layout_->step(ways)) return true;
  finish(layout_->root_from_place());
  if (solution_.problem.empty()) solution_.layout_from_place = layout_->take();
  layout_.reset();
  return false;
}

void SiteSolver::finish(const PlacePoses& root_from_place) {
  std::vector<SitePick> picks;
  std::vector<std::size_t> numbers;
  for (std::size_t at = 0; at < solution_.fits.size(); ++at) {
    if (!solution_.fits[at].is_in_map) continue;
    const Pick& pick = solution_.registration.picks[at];
    const Pose2* const pose = root_from_place.find(pick.place);
    if (pose == nullptr) {
      solution_.problem = "picks " + picks.front().name + " and " + pick.name +
                          " lie in parts of the map that nothing joins: teach a run from one to the other, or pick "
                          "places of one part";
      return;
    }
    picks.push_back({pick.name, *pose, pick.in_place, pick.on_plan, pick.heading, pick.sigma_m});
    numbers.push_back(at);
  }
  Result<SiteFrame> frame = fit_site_frame(picks);
  solution_.problem = frame ? ambiguity(picks, *frame) : frame.error().message;
  if (!solution_.problem.empty()) return;
  solution_.frame = *std::move(frame);
  for (std::size_t at = 0; at < picks.size(); ++at) solution_.fits[numbers[at]].off_m = solution_.frame.off_m[at];
  for (const std::size_t at : solution_.frame.left_out) solution_.fits[numbers[at]].is_left_out = true;
}

SiteSolution SiteSolver::take() {
  return std::move(solution_);
}

SiteSolution solve_site(NetworkView network, Registration registration) {
  SiteSolver solver(std::move(network), std::move(registration));
  while (solver.step(std::numeric_limits<std::uint32_t>::max())) {
  }
  return solver.take();
}

}  // namespace weft
