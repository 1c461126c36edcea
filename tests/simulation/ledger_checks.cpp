#include <algorithm>
#include <cmath>

#include "core/network/search.hpp"
#include "tests/simulation/ledger.hpp"

namespace weft::simulation {

void Ledger::look(const server::Service& service, const storage::MemoryDisk& disk) {
  check_acknowledged(service, disk);
  check_revisions(service, disk);
  check_stitches(service.snapshot());
  check_goals(service);
}

/// Nothing acknowledged is lost or doubled: each batch is there with its contents, and the network holds its places
/// once.
void Ledger::check_acknowledged(const server::Service& service, const storage::MemoryDisk& disk) {
  for (const auto& [experience, through] : acknowledged_) {
    std::size_t places = 0;
    for (std::uint64_t sequence = 1; sequence <= through; ++sequence) {
      const Batch& batch = sent_[experience][sequence];
      const auto stored = disk.batch_hashes.find({experience, sequence});
      if (stored == disk.batch_hashes.end() || stored->second != hash(batch)) {
        broken("acknowledged",
               "batch " + std::to_string(sequence) + " of " + to_string(experience) + " is lost or changed");
        continue;
      }
      for (const Place& place : batch.places) {
        if (!disk.contents.contains(place.content.hash)) {
          broken("acknowledged", "the content of " + to_string(place.id) + " is lost");
        }
        const Place* const served = service.snapshot().place(place.id);
        const bool is_served = served != nullptr && *served == place;
        if (!is_served && !(served == nullptr && is_edited_))
          broken("acknowledged", "place " + to_string(place.id) + " is not served");
      }
      places += batch.places.size();
    }
    const Experience* const served = service.snapshot().experience(experience);
    std::size_t sent = 0;
    for (const auto& [sequence, batch] : sent_[experience]) sent += batch.places.size();
    if (through > 0 && !is_edited_ &&
        (served == nullptr || served->places.size() < places || served->places.size() > sent)) {
      broken("acknowledged", to_string(experience) + " has " + std::to_string(served ? served->places.size() : 0) +
                                 " places, acknowledged were " + std::to_string(places));
    }
  }
}

/// Checks that, whatever the disk refused or tore, revisions follow one another, the server's map is the disk's
/// newest, and no batch is there twice.
void Ledger::check_revisions(const server::Service& service, const storage::MemoryDisk& disk) {
  if (service.snapshot().revision() != disk.revision) {
    broken("revisions", "the server's map is of revision " + std::to_string(service.snapshot().revision().value) +
                            ", the disk's newest is " + std::to_string(disk.revision.value));
  }
  std::uint64_t expected = 0;
  for (const storage::RevisionNote& note : disk.notes) {
    if (note.revision.value != ++expected)
      broken("revisions", "revision " + std::to_string(expected) + " has no note");
  }
  if (expected != disk.revision.value) broken("revisions", "the newest revision has no note");
  std::map<storage::BatchKey, std::size_t> times;
  for (const storage::MemoryDisk::Step& step : disk.history) {
    const auto* const batch = std::get_if<Batch>(&step.change);
    if (batch == nullptr || ++times[{batch->experience, batch->sequence}] == 1) continue;
    broken("acknowledged",
           "batch " + std::to_string(batch->sequence) + " of " + to_string(batch->experience) + " is stored twice");
  }
}

void Ledger::check_stitches(const Snapshot& snapshot) {
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Edge& stitch : experience->stitches) {
      if (!checked_stitches_.insert(stitch.id).second) continue;
      const auto a = truth_of(stitch.id.a);
      const auto b = truth_of(stitch.id.b);
      if (!a || !b) continue;
      const Pose2 off = (a->inverse() * *b).inverse() * planar(stitch.a_from_b);
      if (off.translation().norm() > 0.10 || std::abs(off.heading) > 3.0 * 3.14159265 / 180.0) {
        broken("stitches", to_string(stitch.id.a) + " to " + to_string(stitch.id.b) + " is off by " +
                               std::to_string(off.translation().norm()) + " m");
      }
    }
  }
}

/// An accepted goal is never forgotten, and an ended one stays as it ended.
void Ledger::check_goals(const server::Service& service) {
  std::map<GoalId, GoalState> now;
  for (const Goal& goal : service.goals()) now[goal.id] = goal.state;
  for (const GoalId& id : accepted_) {
    if (!now.contains(id)) broken("goals", "accepted goal " + to_string(id) + " is forgotten");
  }
  for (const auto& [id, state] : ended_) {
    if (now.contains(id) && now[id] != state) {
      broken("goals",
             "goal " + to_string(id) + " had ended as " + to_string(state) + " and is " + to_string(now[id]));
    }
  }
  for (const auto& [id, state] : now) {
    if (is_terminal(state)) ended_[id] = state;
  }
  seen_ = std::move(now);
}

/// Whether nobody who may serve the goal knows where he is: it stays possible, and ends when people find the robot.
bool Ledger::waits_for_the_lost(const Goal& goal) const {
  const std::optional<RobotId> only = goal.robot ? goal.robot : goal.wanted;
  return std::ranges::none_of(robots, [&](const auto& entry) {
    const auto& [id, robot] = entry;
    return (!only || *only == id) && robot.state.localised && robot.state.mode != msg::RobotMode::lost;
  });
}

void Ledger::look_when_quiet(const server::Service& service, const storage::MemoryDisk& disk) {
  look(service, disk);
  check_spools_when_quiet(service.snapshot(), disk);
  for (const auto& [id, robot] : robots) {
    const Digest mine = digest(robot.agent->window());
    const Digest served = digest(make_window(service.snapshot(), robot.wants));
    if (mine != served) {
      broken("windows", robot.name + " holds a window of " + std::to_string(robot.agent->window().places.size()) +
                            " places that is not the server's");
    }
  }
  for (const auto& [experience, batches] : sent_) {
    if (acknowledged_[experience] < batches.rbegin()->first) {
      broken("acknowledged", "batch " + std::to_string(batches.rbegin()->first) + " of " + to_string(experience) +
                                 " was never acknowledged");
    }
  }
  std::map<RobotId, bool> busy;
  for (const Goal& goal : service.goals()) {
    if (goal.robot && !is_terminal(goal.state) && goal.state != GoalState::pending) busy[*goal.robot] = true;
  }
  for (const Goal& goal : service.goals()) {
    if (is_terminal(goal.state) || waits_for_the_lost(goal)) continue;
    broken("goals", "goal " + to_string(goal.id) + " to " + goal.label + " has not ended though people helped: " +
                        to_string(goal.state) + ", " + goal.history.back().cause);
    if (goal.state == GoalState::pending) {
      for (const auto& [id, robot] : robots) {
        const bool able = (!goal.wanted || *goal.wanted == id) && !busy[id] && robot.state.localised &&
                          robot.state.mode == msg::RobotMode::idle &&
                          shortest_path(service.snapshot(), robot.state.place, goal.to, {"marks"}).has_value();
        if (able)
          broken("goals", "goal " + to_string(goal.id) + " is pending while " + robot.name + " could take it");
      }
    } else if (goal.robot && robots.at(*goal.robot).state.goal != goal.id &&
               robots.at(*goal.robot).state.mode != msg::RobotMode::lost && robots.at(*goal.robot).state.localised) {
      broken("goals", "goal " + to_string(goal.id) + " is " + to_string(goal.state) + " and " +
                          robots.at(*goal.robot).name + " knows nothing of it");
    }
  }
}

std::map<std::string, std::uint64_t> Ledger::goals_by_state() const {
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [id, state] : seen_) ++counts[to_string(state)];
  return counts;
}

}  // namespace weft::simulation
