#include "server/site/site_frames.hpp"

#include <chrono>
#include <utility>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Leaves room for messages between two pieces.
constexpr Duration kBetweenSitePieces = 1ms;
/// Bounds how often a map that changes all the time, as it does while robots are taught, is laid out anew.
constexpr Duration kBetweenSiteMaps = 1s;

std::string plans_of(const Snapshot::Registrations& registrations) {
  std::string text;
  for (const auto& [plan, registration] : registrations) text += (text.empty() ? "" : ", ") + plan;
  return text;
}

}  // namespace

const SiteSolution* SiteFrames::solution(const std::string& plan) const {
  const auto found = solutions_.find(plan);
  return found == solutions_.end() ? nullptr : &found->second;
}

bool SiteFrames::is_due() const {
  const Snapshot& map = context_.snapshots.current();
  return solved_ != map.revision() && !(map.registrations().empty() && solutions_.empty());
}

std::optional<SiteFrames::OnPlan> SiteFrames::pose(const PlaceId& place) const {
  const Snapshot::Registrations& known = context_.snapshots.current().registrations();
  for (const auto& [plan, solution] : solutions_) {
    const auto registered = known.find(plan);
    if (registered == known.end() || registered->second != solution.registration) continue;
    if (const std::optional<Pose2> pose = solution.plan_from_place(place)) return OnPlan{plan, *pose};
  }
  return std::nullopt;
}

Result<PlaceId> SiteFrames::nearest(const std::string& plan, const Eigen::Vector2d& on_plan) const {
  const Snapshot& map = context_.snapshots.current();
  const Snapshot::Registrations& known = map.registrations();
  if (known.empty()) {
    return fail(ErrorCode::not_found,
                "no floor plan is registered to the map: weft map register PLAN.yaml --pick LABEL=X,Y");
  }
  if (plan.empty() && known.size() > 1) {
    return fail(ErrorCode::refused,
                "several floor plans are registered: say with --plan which of " + plans_of(known));
  }
  const std::string& name = plan.empty() ? known.begin()->first : plan;
  if (!known.contains(name)) {
    return fail(ErrorCode::not_found, "no floor plan " + name + " is registered; known: " + plans_of(known));
  }
  const SiteSolution* const found = solution(name);
  if (found == nullptr || found->registration != known.at(name)) {
    return fail(ErrorCode::refused, "where the map lies on plan " + name + " is being worked out: ask again");
  }
  Result<PlaceId> place = found->nearest(on_plan, kNearGoal_m);
  if (!place || map.place(*place) != nullptr) return place;
  return fail(ErrorCode::refused, "the map has just changed there, and where it lies on plan " + name +
                                      " is being worked out: ask again");
}

void SiteFrames::begin(SteadyTime now) {
  work_.emplace();
  work_->map = context_.snapshots.shared_current();
  work_->at = work_->map->registrations().begin();
  next_piece_ = now;
}

void SiteFrames::tick(Now now) {
  if (now.steady < next_piece_) return;
  if (!work_ && !is_due()) return;
  if (!work_) begin(now.steady);
  next_piece_ = now.steady + kBetweenSitePieces;
  const Snapshot::Registrations& all = work_->map->registrations();
  if (work_->solver) {
    if (work_->solver->step(kWaysOfSitePiece)) return;
    work_->solved.emplace(work_->at->first, work_->solver->take());
    work_->solver.reset();
    ++work_->at;
  } else if (work_->at != all.end()) {
    work_->solver.emplace(view_of(work_->map), work_->at->second);
  }
  if (work_->solver || work_->at != all.end()) return;
  solutions_ = std::move(work_->solved);
  solved_ = work_->map->revision();
  work_.reset();
  next_piece_ = now.steady + kBetweenSiteMaps;
}

std::optional<SteadyTime> SiteFrames::next() const {
  return work_ || is_due() ? std::optional(next_piece_) : std::nullopt;
}

}  // namespace weft::server
