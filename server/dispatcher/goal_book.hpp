#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/network/goal.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Keeps every goal with its life and its latest route, as the store has them. A step is in here only once it is
/// durable.
class GoalBook {
 public:
  GoalBook(Context& context, std::map<GoalId, Goal> goals, std::map<GoalId, Route> routes);

  struct Step {
    GoalState state = GoalState::pending;
    std::string cause;
    std::string who;
    const char* kind = nullptr;  ///< of the event; none: "goal.<state>"
  };
  /// Writes `goal`, with the step added to its history, its event, and what else is in `transaction`; on success the
  /// book has it. A route in `route` becomes the goal's latest; a goal that has none any more is without one.
  Result<void> write(Goal goal, const Step& step, const std::optional<Route>& route, storage::Transaction transaction,
                     Now now);
  struct Waiting {
    GoalId goal;
    std::string why;
  };
  /// Writes what pending goals wait for, in one transaction; nothing when there are none.
  Result<void> write(const std::vector<Waiting>& waiting, Now now);
  /// Writes a route whose release has grown, or its next version, which nobody needs to be told of.
  Result<void> write(const Route& route, storage::Transaction transaction, Now now);

  const Goal* find(const GoalId& id) const;
  const Route* route(const GoalId& id) const;
  const std::map<GoalId, Goal>& goals() const { return goals_; }
  /// Returns the goals that are not over, in the order in which they were accepted.
  const std::map<std::uint64_t, GoalId>& alive() const { return alive_; }
  std::uint64_t next_number() const { return next_number_; }

 private:
  void index(const Goal& goal);
  static void add(Goal& goal, const Step& step, storage::Transaction& transaction, Now now);

  Context& context_;
  std::map<GoalId, Goal> goals_;
  std::map<GoalId, Route> routes_;
  std::map<std::uint64_t, GoalId> alive_;
  std::uint64_t next_number_ = 1;
};

}  // namespace weft::server
