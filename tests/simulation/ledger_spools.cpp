#include <algorithm>

#include "tests/simulation/ledger.hpp"

/// Checks that what a robot has on its disk arrives, whatever the disk refuses.
namespace weft::simulation {
namespace {

/// Is how often an agent tries again what its disk has refused, and a little more.
constexpr Duration kTriesAgain = std::chrono::seconds(2);

std::vector<storage::BatchKey> keys_of(const storage::SpoolDisk& spool) {
  std::vector<storage::BatchKey> keys;
  for (const storage::SpoolRecord& record : spool.records) {
    if (!record.batch.places.empty()) keys.emplace_back(record.batch.experience, record.batch.sequence);
  }
  return keys;
}

std::string text_of(const storage::BatchKey& batch) {
  return "batch " + std::to_string(batch.second) + " of " + to_string(batch.first);
}

}  // namespace

/// A robot whose disk would not take that it has to stand does not know it any more once its agent has ended.
void Ledger::agent_started(const RobotId& robot, const agents::Agent& agent, const storage::SpoolDisk& disk) {
  Robot& by = robots.at(robot);
  by.agent = &agent;
  if (!std::exchange(by.ended_while_struck, false)) return;
  by.is_stopped = by.is_stopped && disk.stops.by_operator;
  by.had_emergency = by.had_emergency && disk.stops.by_emergency_stop;
}

void Ledger::agent_ended(const RobotId& robot) {
  Robot& by = robots.at(robot);
  by.agent = nullptr;
  by.had.reset();
  by.is_hung = false;
  by.ended_while_struck = by.ended_while_struck || (by.struck && now_ - *by.struck <= kTriesAgain);
}

void Ledger::spool_struck(const RobotId& robot) {
  Robot& by = robots.at(robot);
  by.struck = now_;
  for (auto& [experience, run] : runs_)
    run.was_refused = run.was_refused || run.taught_in == by.state.header.incarnation;
}

void Ledger::look_at_spool(const RobotId& robot, const storage::SpoolDisk& spool, const storage::MemoryDisk& disk) {
  Robot& by = robots.at(robot);
  std::vector<storage::BatchKey> now = keys_of(spool);
  if (now == by.spooled) return;
  for (const storage::BatchKey& batch : by.spooled) {
    const bool is_there = std::ranges::find(now, batch) != now.end() || disk.batch_hashes.contains(batch);
    if (!is_there)
      broken("spooled", text_of(batch) + " has gone from " + by.name + ", and the server does not have it");
  }
  by.spooled = std::move(now);
}

/// Checks that the server has all batches of robots' disks by now, and that runs which nobody teaches are sealed.
void Ledger::check_spools_when_quiet(const Snapshot& snapshot, const storage::MemoryDisk& disk) {
  for (const auto& [id, robot] : robots) {
    for (const storage::BatchKey& batch : robot.spooled) {
      if (disk.batch_hashes.contains(batch) || refused_.contains(batch.first)) continue;
      broken("spooled", text_of(batch) + " is on " + robot.name + " alone still");
    }
  }
  for (const auto& [id, experience] : snapshot.experiences()) {
    const auto robot = robots.find(experience->robot);
    if (experience->sealed || experience->places.empty() || robot == robots.end()) continue;
    if (robot->second.state.experience == id) continue;
    broken("sealed", to_string(id) + " is open still, and " + robot->second.name + " teaches it no more");
  }
}

}  // namespace weft::simulation
