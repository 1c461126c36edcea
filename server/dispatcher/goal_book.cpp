#include "server/dispatcher/goal_book.hpp"

#include <algorithm>
#include <utility>

namespace weft::server {
namespace {
/// Bounds the history of a goal that waits for long: it keeps how it began and what happened last.
constexpr std::size_t kHistory = 100;
}  // namespace

GoalBook::GoalBook(Context& context, std::map<GoalId, Goal> goals, std::map<GoalId, Route> routes)
    : context_(context), goals_(std::move(goals)), routes_(std::move(routes)) {
  for (const auto& [id, goal] : goals_) index(goal);
}

void GoalBook::index(const Goal& goal) {
  next_number_ = std::max(next_number_, goal.number + 1);
  if (is_terminal(goal.state)) {
    alive_.erase(goal.number);
  } else {
    alive_[goal.number] = goal.id;
  }
}

/// Adds the step to the goal's history, and both to the transaction with the step's event.
void GoalBook::add(Goal& goal, const Step& step, storage::Transaction& transaction, Now now) {
  goal.state = step.state;
  goal.history.push_back({.at = now.wall, .state = step.state, .cause = clipped(step.cause), .who = step.who});
  if (goal.history.size() > kHistory) goal.history.erase(goal.history.begin() + 1);
  transaction.changes.emplace_back(storage::PutGoal{goal});
  const std::string kind = step.kind != nullptr ? step.kind : std::string("goal.") + to_string(step.state);
  transaction.changes.emplace_back(storage::PutEvent{{.at = {},
                                                      .kind = kind,
                                                      .robot = goal.robot.value_or(RobotId{}),
                                                      .goal = goal.id,
                                                      .cause = step.cause,
                                                      .who = step.who}});
}

Result<void> GoalBook::write(Goal goal, const Step& step, const std::optional<Route>& route,
                             storage::Transaction transaction, Now now) {
  if (route) {
    goal.route = route->id;
    goal.route_version = route->version;
    transaction.changes.emplace_back(storage::PutRoute{*route});
  }
  add(goal, step, transaction, now);
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) {
    return fail(done.error());
  }
  if (route) routes_[goal.id] = *route;
  if (!goal.route) routes_.erase(goal.id);
  index(goal);
  goals_[goal.id] = std::move(goal);
  return {};
}

Result<void> GoalBook::write(const std::vector<Waiting>& waiting, Now now) {
  if (waiting.empty()) return {};
  storage::Transaction transaction;
  std::vector<Goal> goals;
  for (const Waiting& one : waiting) {
    const Step step = {.state = GoalState::pending, .cause = one.why, .who = "dispatcher", .kind = "goal.waits"};
    add(goals.emplace_back(goals_.at(one.goal)), step, transaction, now);
  }
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) {
    return fail(done.error());
  }
  for (Goal& goal : goals) goals_[goal.id] = std::move(goal);
  return {};
}

Result<void> GoalBook::write(const Route& route, storage::Transaction transaction, Now now) {
  transaction.changes.emplace_back(storage::PutRoute{route});
  Goal goal = goals_.at(route.goal);
  const bool is_other = goal.route_version != route.version;
  goal.route_version = route.version;
  if (is_other) transaction.changes.emplace_back(storage::PutGoal{goal});
  if (const auto done = context_.writer.commit(std::move(transaction), now); !done) {
    return fail(done.error());
  }
  routes_[route.goal] = route;
  if (is_other) goals_[route.goal] = std::move(goal);
  return {};
}

const Goal* GoalBook::find(const GoalId& id) const {
  const auto found = goals_.find(id);
  return found == goals_.end() ? nullptr : &found->second;
}

const Route* GoalBook::route(const GoalId& id) const {
  const auto found = routes_.find(id);
  return found == routes_.end() ? nullptr : &found->second;
}

}  // namespace weft::server
