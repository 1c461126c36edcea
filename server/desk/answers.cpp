#include "server/desk/answers.hpp"

#include <algorithm>
#include <utility>

namespace weft::server {
namespace {

constexpr std::size_t kRobotsInPart = 8;  ///< each may describe many cameras
constexpr std::size_t kEventsInPart = 100;
constexpr std::size_t kMostEvents = 1000;
constexpr std::size_t kMostGoals = 1000;
constexpr std::size_t kRevisionsInPart = 100;
constexpr std::size_t kMostRevisions = 1000;
/// Places of routes and events of goals that go into one part, about.
constexpr std::size_t kGoalWeightOfPart = 600;

}  // namespace

void Answers::on_query(const msg::Query& query, SteadyTime now) const {
  std::vector<msg::QueryReply> parts;
  switch (query.kind) {
    case msg::Query::Kind::robots:
      parts = robots(now);
      break;
    case msg::Query::Kind::goals:
      parts = goals(query);
      break;
    case msg::Query::Kind::events:
      parts = events(query);
      break;
    case msg::Query::Kind::log:
      parts = log(query);
      break;
    case msg::Query::Kind::info:
      break;
  }
  if (parts.empty()) parts.emplace_back();
  const auto count = static_cast<std::uint32_t>(parts.size());
  for (std::uint32_t part = 0; part < count; ++part) {
    msg::QueryReply& reply = parts[part];
    reply.to = query.header.sender;
    reply.request = query.request;
    reply.part = part;
    reply.parts = count;
    if (query.kind == msg::Query::Kind::info) reply.info = info();
    context_.out.send(std::move(reply));
  }
}

std::string Answers::occupies(const RobotId& robot) const {
  const storage::PutOccupancy* const held = traffic_.held(robot);
  if (held == nullptr) return {};
  const std::string from = to_string(held->held.places[held->from]);
  return held->from == held->to ? from : from + " to " + to_string(held->held.places[held->to]);
}

std::vector<msg::QueryReply> Answers::robots(SteadyTime now) const {
  std::vector<msg::QueryReply> parts;
  for (const auto& [id, robot] : fleet_.robots()) {
    if (parts.empty() || parts.back().robots.size() == kRobotsInPart) parts.emplace_back();
    msg::RobotRow row;
    if (robot.description) row.description = *robot.description;
    if (robot.state) row.state = *robot.state;
    row.description.name = robot.name;
    row.description.header.sender = id;
    row.silent_s = seconds(now - robot.heard);
    row.vendor = robot.vendor;
    row.software = robot.software;
    row.clock_skew_s = robot.skew.seconds_ahead().value_or(0.0);
    row.occupies = occupies(id);
    row.window_bytes = robot.window_bytes;
    row.content_bytes = robot.content_bytes;
    parts.back().robots.push_back(std::move(row));
  }
  return parts;
}

std::vector<msg::QueryReply> Answers::goals(const msg::Query& query) const {
  std::vector<const Goal*> wanted;
  for (const auto& [id, goal] : book_.goals()) {
    if (!query.goal || query.goal == id) wanted.push_back(&goal);
  }
  std::sort(wanted.begin(), wanted.end(), [](const Goal* a, const Goal* b) { return a->number < b->number; });
  if (wanted.size() > kMostGoals) wanted.erase(wanted.begin(), wanted.end() - kMostGoals);
  std::vector<msg::QueryReply> parts;
  std::size_t weight = 0;
  for (const Goal* const goal : wanted) {
    const Route* const route = book_.route(goal->id);
    const std::size_t more = 1 + goal->history.size() + (route != nullptr ? route->places.size() : 0);
    if (parts.empty() || weight + more > kGoalWeightOfPart) {
      parts.emplace_back();
      weight = 0;
    }
    weight += more;
    parts.back().goals.push_back(*goal);
    if (route != nullptr) parts.back().routes.push_back(*route);
  }
  return parts;
}

std::vector<msg::QueryReply> Answers::events(const msg::Query& query) const {
  RobotId robot;
  if (!query.robot.empty()) {
    const Result<RobotId> id = fleet_.by_name(query.robot);
    if (!id) return {};
    robot = *id;
  }
  const Result<std::vector<msg::Event>> events = context_.store.events(query.goal, robot, kMostEvents);
  std::vector<msg::QueryReply> parts;
  if (!events) return parts;
  for (const msg::Event& event : *events) {
    if (parts.empty() || parts.back().events.size() == kEventsInPart) parts.emplace_back();
    parts.back().events.push_back(event);
  }
  return parts;
}

std::vector<msg::QueryReply> Answers::log(const msg::Query& query) const {
  std::vector<msg::QueryReply> parts;
  Result<std::vector<msg::RevisionNote>> notes =
      context_.store.log(query.newest, std::min<std::size_t>(query.most, kMostRevisions));
  if (!notes) return parts;
  for (msg::RevisionNote& note : *notes) {
    if (parts.empty() || parts.back().log.size() == kRevisionsInPart) parts.emplace_back();
    note.cause = clipped(std::move(note.cause));
    parts.back().log.push_back(std::move(note));
  }
  return parts;
}

msg::MapInfo Answers::info() const {
  const Snapshot& snapshot = context_.snapshots.current();
  const storage::StoreSize size = context_.store.size();
  msg::MapInfo info;
  info.revision = snapshot.revision();
  info.epoch = context_.out.epoch();
  info.experiences = snapshot.experience_count();
  info.places = snapshot.place_count();
  info.stitches = snapshot.stitch_count();
  info.contents = size.contents;
  info.content_bytes = size.content_bytes;
  info.batches_acknowledged = intake_.acknowledged();
  info.batches_refused = intake_.refused();
  info.disk_free_bytes = size.disk_free_bytes;
  info.software = context_.config.software;
  info.vendor = context_.config.vendor;
  info.engine = context_.store.engine();
  for (const auto& [what, times] : context_.counters) info.counters.emplace_back(what, times);
  if (context_.record.stopped()) info.stopped = clipped(context_.record.stopped()->message);
  return info;
}

}  // namespace weft::server
