#include <algorithm>
#include <sstream>
#include <utility>

#include "tests/simulation/operator.hpp"

namespace weft::simulation {
namespace {

constexpr double kRoom_m = 2.5;
constexpr Duration kPatience = std::chrono::minutes(4);
constexpr Duration kFaceToFace = std::chrono::seconds(40);

/// Returns who the goal waits for, by the last that its history says: "A waits until B, C and D have left its way".
std::vector<std::string> blockers_of(const Goal& goal) {
  static const std::string before = " waits until ";
  for (auto event = goal.history.rbegin(); event != goal.history.rend(); ++event) {
    const std::string& cause = event->cause;
    if (cause.ends_with(" left the way")) return {};
    const auto begin = cause.find(before);
    if (begin == std::string::npos || !cause.ends_with(" left its way")) continue;
    std::istringstream words(cause.substr(begin + before.size()));
    std::vector<std::string> names;
    for (std::string word; words >> word && word != "has" && word != "have";) {
      if (word != "and") names.push_back(word.substr(0, word.find(',')));
    }
    return names;
  }
  return {};
}

}  // namespace

std::optional<std::size_t> Operator::robot_named(const std::string& name) const {
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
    if (fleet_.name(robot) == name) return robot;
  }
  return std::nullopt;
}

/// Returns who the goal was given to.
std::optional<std::size_t> Operator::serving(const Goal& goal) const {
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
    if (goal.robot == fleet_.id_of(robot)) return robot;
  }
  return std::nullopt;
}

bool Operator::is_idle(std::size_t robot) const {
  const msg::RobotState& state = fleet_.state(robot);
  return fleet_.robot_up(robot) && state.mode == msg::RobotMode::idle && !state.route;
}

bool Operator::has_errand(std::size_t robot) const {
  const RobotId& id = fleet_.id_of(robot);
  return std::any_of(open_.begin(), open_.end(), [&](const auto& entry) {
    const Goal& goal = entry.second.goal;
    return goal.robot == id || goal.wanted == id;
  });
}

/// Returns the stations that nobody is sent to, and where nobody stands, as one sees who walks there.
std::vector<std::string> Operator::free_stations() const {
  std::vector<std::string> free;
  for (const auto& [label, station] : stations_) {
    const bool is_asked_for =
        std::any_of(open_.begin(), open_.end(), [&](const auto& entry) { return entry.second.label == label; });
    const Pose2 there = fleet_.site().station(station);
    bool is_taken = false;
    for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
      const Pose2& here = fleet_.body(robot).site_from_robot();
      is_taken = is_taken || (here.translation() - there.translation()).norm() < kRoom_m;
    }
    if (!is_asked_for && !is_taken) free.push_back(label);
  }
  return free;
}

/// Returns a free station; empty when there is none.
std::string Operator::free_station() {
  const std::vector<std::string> free = free_stations();
  return free.empty() ? std::string() : free[random_.below(free.size())];
}

/// Returns the answer to a question; none when it is not answered.
std::optional<msg::QueryReply> Operator::answer_to(msg::Query query) {
  query.request = random_.next();
  for (int tries = 0; tries < 5; ++tries) {
    fleet_.send(query);
    for (int i = 0; i < 8; ++i) {
      pass(std::chrono::milliseconds(250));
      for (const msg::QueryReply& answer : fleet_.take_answers()) {
        if (answer.request == query.request) return answer;
      }
    }
  }
  return std::nullopt;
}

/// Asks for many goals at once, as `weft goal show` does for one. Returns what each answer holds: nothing where the
/// server knows of no such goal. Leaves out goals for which no answer came.
std::map<GoalId, std::vector<Goal>> Operator::look_at(std::vector<GoalId> goals) {
  std::map<GoalId, std::vector<Goal>> found;
  for (int tries = 0; tries < 5 && !goals.empty(); ++tries) {
    std::map<std::uint64_t, GoalId> asked;
    for (const GoalId& goal : goals) {
      msg::Query query;
      query.kind = msg::Query::Kind::goals;
      query.goal = goal;
      query.request = random_.next();
      asked[query.request] = goal;
      fleet_.send(query);
    }
    for (int i = 0; i < 8 && !asked.empty(); ++i) {
      pass(std::chrono::milliseconds(250));
      for (msg::QueryReply& answer : fleet_.take_answers()) {
        const auto goal = asked.find(answer.request);
        if (goal == asked.end()) continue;
        found[goal->second] = std::move(answer.goals);
        asked.erase(goal);
      }
    }
    goals.clear();
    for (const auto& [request, goal] : asked) goals.push_back(goal);
  }
  return found;
}

/// Returns, from `weft map log`, the latest revision if it took places out of the map; 0 when the latest edit did
/// not.
Revision Operator::quarantined() {
  msg::Query query;
  query.kind = msg::Query::Kind::log;
  query.most = 1000;
  std::optional<msg::QueryReply> answer;
  while (!answer) answer = answer_to(query);
  for (const msg::RevisionNote& note : answer->log) {
    if (note.kind == "quarantine") return note.revision;
    if (note.kind == "undo") return {};
  }
  return {};
}

/// Notes the goal's robot if it has failed off its route: left askew by a hand, it cannot set off.
void Operator::note_stray(const Goal& goal) {
  const bool is_off = goal.state == GoalState::failed && goal.history.back().cause == "off_route";
  if (const auto robot = serving(goal); is_off && robot) strays_.insert(*robot);
}

void Operator::look_around() {
  std::vector<GoalId> ids;
  for (const auto& [id, open] : open_) ids.push_back(id);
  for (auto& [id, goals] : look_at(std::move(ids))) {
    // A server that knows of no such goal: the request never arrived.
    if (goals.empty() || is_terminal(goals.front().state)) {
      open_.erase(id);
      if (!goals.empty()) note_stray(goals.front());
      continue;
    }
    Open& open = open_[id];
    if (open.goal.history.size() != goals.front().history.size()) open.since = fleet_.now();
    open.goal = std::move(goals.front());
  }
}

bool Operator::waits_for(std::size_t robot, const std::string& other) const {
  return std::any_of(open_.begin(), open_.end(), [&](const auto& entry) {
    if (entry.second.goal.robot != fleet_.id_of(robot)) return false;
    const std::vector<std::string> blockers = blockers_of(entry.second.goal);
    return std::find(blockers.begin(), blockers.end(), other) != blockers.end();
  });
}

/// Returns a robot in the goal's way: one that has nothing to do, else the first.
std::optional<std::size_t> Operator::blocker_of(const Goal& goal) const {
  const std::vector<std::string> names = blockers_of(goal);
  std::optional<std::size_t> first;
  for (const std::string& name : names) {
    const std::optional<std::size_t> robot = robot_named(name);
    if (robot && is_idle(*robot) && !has_errand(*robot)) return robot;
    if (!first) first = robot;
  }
  return first;
}

/// Sends away who stands in the way with nothing to do. Who waits for long all the same gives up, and a hand takes it
/// on a little: two robots that stand too close each keep the other from setting off. Of two that stand face to face,
/// each on the other's way, one is taken out of it.
void Operator::help_waiting(const GoalId& id, Open& open) {
  const std::optional<std::size_t> blocker = blocker_of(open.goal);
  if (!blocker) return;
  if (is_idle(*blocker) && fleet_.state(*blocker).localised && !has_errand(*blocker)) {
    if (const std::string label = free_station(); !label.empty()) send_goal(label, fleet_.name(*blocker));
    return;
  }
  const std::optional<std::size_t> waiting = serving(open.goal);
  const bool face_to_face = waiting && waits_for(*blocker, fleet_.name(*waiting));
  if (fleet_.now() - open.since < (face_to_face ? kFaceToFace : kPatience) ||
      fleet_.state(*blocker).mode == msg::RobotMode::driving)
    return;
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::goal_cancel;
  request.goal = id;
  ask(request);
  if (!waiting) return;
  wait(20.0, [&] { return is_idle(*waiting); });
  if (face_to_face || !teach_more(*waiting)) take_away(*waiting);
}

void Operator::help_all_waiting() {
  std::vector<GoalId> ids;
  for (const auto& [id, open] : open_) ids.push_back(id);
  for (const GoalId& id : ids) {
    if (const auto found = open_.find(id); found != open_.end()) help_waiting(id, found->second);
  }
}

/// Leads a stray to where it can set off: out of everybody's way, or, where people do not help with traffic, on along
/// the lane that it stands beside; later when that cannot be done now.
void Operator::lead_back(std::size_t robot) {
  if (people_ == People::help) return take_away(robot);
  if (!is_idle(robot)) return;
  if (!teach_more(robot)) {
    strays_.insert(robot);
    return;
  }
  ++led_back_;
}

/// Returns the robots that stand where no way leads on from, as goals say that wait for one: a run by hand may end
/// beside all lanes.
std::set<std::size_t> Operator::at_dead_ends() const {
  std::set<std::size_t> robots;
  for (const auto& [id, open] : open_) {
    if (open.goal.history.empty()) continue;
    for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
      const std::string from_there = "no path from " + to_string(fleet_.state(robot).place) + " to ";
      if (open.goal.history.back().cause.starts_with(from_there)) robots.insert(robot);
    }
  }
  return robots;
}

void Operator::help() {
  look_around();
  if (people_ == People::help) {
    help_all_waiting();
    for (const std::size_t robot : at_dead_ends()) teach_more(robot);
  }
  for (const std::size_t robot : std::exchange(strays_, {})) lead_back(robot);
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
    const msg::RobotState& state = fleet_.state(robot);
    if (!fleet_.robot_up(robot)) continue;
    if (state.mode == msg::RobotMode::teaching) teach_stop(robot);
    // Nobody stops one for longer than an errand: its disk did not take that it may go on, and its agent has ended.
    if (state.mode == msg::RobotMode::stopped) resume(robot);
    if (state.mode != msg::RobotMode::idle || state.localised) continue;
    msg::OperatorRequest request;
    request.kind = msg::OperatorRequest::Kind::localise;
    request.robot = fleet_.name(robot);
    ask(request);
  }
}

}  // namespace weft::simulation
