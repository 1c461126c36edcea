#pragma once
#include <map>
#include <optional>
#include <string>

#include "core/network/site_solver.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Is how many ways from place to place are looked at in one piece of work: well under a tenth of what may be done
/// between two messages.
inline constexpr std::size_t kWaysOfSitePiece = 2'000;

/// Works out where the map lies on the registered floor plans, anew for each revision, a piece at a time between
/// messages. For people and their pictures: nothing of it is stored, and no robot drives by it.
class SiteFrames {
 public:
  explicit SiteFrames(Context& context) : context_(context) {}

  /// Returns what was found last, for this revision or an earlier one; null: nothing yet, or no such registration.
  const SiteSolution* solution(const std::string& plan) const;

  struct OnPlan {
    std::string plan;
    Pose2 plan_from_place;
  };
  /// Returns where a place lies, on the first plan by name on which it does; none: on none, or it is still being
  /// worked out by the picks that are registered now.
  std::optional<OnPlan> pose(const PlaceId& place) const;
  /// Finds the place nearest to a point of a plan; no name: of the only plan. refused: it is not known which plan is
  /// meant, or nothing lies on it; not_found: there is no such plan, or no place within `kNearGoal_m`.
  Result<PlaceId> nearest(const std::string& plan, const Eigen::Vector2d& on_plan) const;

  /// Does one bounded piece of work, if there is any.
  void tick(Now now);
  std::optional<SteadyTime> next() const;

 private:
  /// Holds the registrations of one revision while they are worked out, one after the other.
  struct Work {
    std::shared_ptr<const Snapshot> map;
    std::map<std::string, SiteSolution> solved;
    std::optional<SiteSolver> solver;
    Snapshot::Registrations::const_iterator at;  ///< that of `solver`, or the next one
  };
  void begin(SteadyTime now);
  bool is_due() const;

  Context& context_;
  std::map<std::string, SiteSolution> solutions_;
  Revision solved_;  ///< what `solutions_` is of
  std::optional<Work> work_;
  SteadyTime next_piece_;
};

inline constexpr double kNearGoal_m = 0.5;

}  // namespace weft::server
