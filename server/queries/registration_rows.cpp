#include "server/queries/registration_rows.hpp"

#include "server/base/clipped.hpp"

namespace weft::server {
namespace {

using PickState = msg::RegistrationRow::PickState;

PickState state_of(const PickFit& fit) {
  if (!fit.is_in_map) return PickState::gone;
  return fit.is_left_out ? PickState::left_out : PickState::counts;
}

msg::RegistrationRow row_of(const Registration& registration, const SiteSolution* solution) {
  msg::RegistrationRow row;
  row.registration = registration;
  if (solution == nullptr || solution->registration != registration) {
    row.problem = "it is being worked out: ask again";
    return row;
  }
  for (const PickFit& fit : solution->fits) row.picks.push_back({.state = state_of(fit), .off_m = fit.off_m});
  row.problem = clipped(solution->problem);
  if (!row.problem.empty()) return row;
  row.places = solution->layout_from_place.size();
  row.scale = solution->frame.scale;
  row.sigma_m = solution->frame.sigma_m;
  row.text = clipped(to_text(*solution));
  return row;
}

}  // namespace

std::vector<msg::RegistrationRow> registration_rows(const Snapshot& map, const SiteFrames& site_frames) {
  std::vector<msg::RegistrationRow> rows;
  for (const auto& [plan, registration] : map.registrations()) {
    rows.push_back(row_of(registration, site_frames.solution(plan)));
    rows.back().all_places = map.place_count();
  }
  return rows;
}

void put_on_plan(const SiteFrames& site_frames, msg::RobotRow& row) {
  if (!row.state.localised || !row.state.place) return;
  const std::optional<SiteFrames::OnPlan> on = site_frames.pose(row.state.place);
  if (!on) return;
  row.plan = on->plan;
  row.plan_from_robot = on->plan_from_place * planar(row.state.place_from_robot);
}

}  // namespace weft::server
