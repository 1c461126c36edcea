#include "server/queries/figures.hpp"

#include <algorithm>
#include <utility>

namespace weft::server {
namespace {

RobotFigures figures_of_robot(const Robot& robot, const Standstills& standstills, SteadyTime now) {
  RobotFigures figures;
  figures.id = robot.id;
  figures.name = robot.name;
  figures.is_heard = !robot.silent;
  figures.was_ended = robot.left;
  figures.are_twins = robot.incarnations.twins();
  figures.is_deaf = !robot.silent && robot.directions.is_deaf();
  figures.silent_s = std::max(seconds(now - robot.heard), 0.0);
  figures.waits = standstills.wait_of(robot.id) != nullptr;
  figures.is_in_standstill = !standstills.text_of(robot.id).empty();
  figures.clock_skew_s = robot.skew.seconds_ahead().value_or(0.0);
  if (robot.power) figures.charge = robot.power->share;
  figures.window_bytes = robot.window_bytes;
  figures.content_bytes = robot.content_bytes;
  figures.messages_heard = robot.reception.heard();
  figures.messages_missed = robot.reception.missed();
  if (!robot.state) return figures;
  const msg::RobotState& state = *robot.state;
  figures.mode = state.mode;
  figures.is_localised = state.localised;
  figures.blind_m = state.blind_m;
  figures.contents_missing = state.contents_missing;
  figures.memory_bytes = state.memory_bytes;
  figures.spool_batches = state.spool_batches;
  figures.spool_free_bytes = state.spool_free_bytes;
  figures.spool_refuses = !state.spool_refuses.empty();
  return figures;
}

void add_goals(const GoalBook& book, WallTime now, Figures& figures) {
  for (const auto& [id, goal] : book.goals()) {
    ++figures.goals[goal.state];
    if (is_terminal(goal.state) || goal.history.empty()) continue;
    figures.oldest_goal_s = std::max(figures.oldest_goal_s, seconds(now - goal.history.front().at));
  }
}

}  // namespace

Figures figures_of(const Measured& measured, Now now) {
  const Context& context = measured.context;
  const Snapshot& map = context.snapshots.current();
  const storage::StoreSize size = context.store.size();
  Figures figures;
  figures.epoch = context.out.epoch();
  figures.revision = map.revision();
  figures.experiences = map.experience_count();
  figures.places = map.place_count();
  figures.stitches = map.stitch_count();
  figures.contents = size.contents;
  figures.content_bytes = size.content_bytes;
  figures.disk_free_bytes = size.disk_free_bytes;
  figures.store_refuses = context.writer.stopped().has_value();
  figures.batches_acknowledged = measured.intake.acknowledged();
  figures.batches_refused = measured.intake.refused();
  figures.intake_bytes = measured.intake.waiting_bytes();
  figures.windows = measured.window_publisher.subscribers();
  figures.windows_behind = measured.window_publisher.behind();
  figures.contents_to_send = measured.content_server.waiting();
  figures.recognitions_waiting = measured.recognition.waiting();
  figures.standstills = measured.standstills.count();
  figures.counters = context.counters;
  add_goals(measured.dispatcher.book(), now.wall, figures);
  for (const auto& [id, robot] : measured.fleet.robots()) {
    figures.robots.push_back(figures_of_robot(robot, measured.standstills, now.steady));
  }
  return figures;
}

}  // namespace weft::server
