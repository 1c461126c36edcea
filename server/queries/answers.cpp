#include "server/queries/answers.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/network/page.hpp"
#include "core/network/rules.hpp"
#include "server/base/outcome.hpp"
#include "server/queries/alarms.hpp"
#include "server/queries/experience_rows.hpp"
#include "server/queries/registration_rows.hpp"

namespace weft::server {
namespace {

constexpr std::size_t kRobotsInPart = 8;  ///< each may describe many cameras
constexpr std::size_t kEventsInPart = 100;
constexpr std::size_t kMostEvents = 1000;
constexpr std::size_t kAlarmsInPart = 100;
constexpr Duration kBetweenAlarms = std::chrono::seconds(1);
constexpr std::size_t kMostGoals = 1000;
constexpr std::size_t kRevisionsInPart = 100;
constexpr std::size_t kMostRevisions = 1000;
constexpr std::size_t kRulesInPart = 100;
/// Bounds the labels and joined experiences that go into one part, about; a row counts for some.
constexpr std::size_t kExperienceWeightOfPart = 10'000;
constexpr std::size_t kRowWeight = 10;
constexpr std::size_t kAwaitedLabelsInPart = 1000;  ///< all that may wait
/// Bounds the places of routes and events of goals that go into one part, about.
constexpr std::size_t kGoalWeightOfPart = 600;
/// Bounds a page, so that it is made, sent and read within a few milliseconds.
constexpr std::size_t kEntitiesOfPage = 4 * msg::kPatchEntities;

}  // namespace

Result<Answers::Parts> Answers::answer(const msg::Query& query, Now now) {
  switch (query.kind) {
    case msg::Query::Kind::robots:
      return robots(now.steady);
    case msg::Query::Kind::goals:
      return goals(query);
    case msg::Query::Kind::events:
      return events(query);
    case msg::Query::Kind::log:
      return log(query);
    case msg::Query::Kind::network:
      return network(query, now.steady);
    case msg::Query::Kind::experiences:
      return experiences();
    case msg::Query::Kind::rules:
      return rules();
    case msg::Query::Kind::registrations:
      return registrations();
    case msg::Query::Kind::alarms:
      return alarms(now);
    case msg::Query::Kind::info:
      break;
  }
  Parts one(1);
  one.front().info = info();
  return one;
}

void Answers::on_query(const msg::Query& query, Now now) {
  Result<Parts> answered = answer(query, now);
  Parts parts;
  if (answered) {
    parts = *std::move(answered);
  } else {
    parts.emplace_back();
    parts.front().outcome = outcome_of(answered.error());
    parts.front().message = clipped(answered.error().message);
  }
  if (parts.empty()) parts.emplace_back();
  const auto count = static_cast<std::uint32_t>(parts.size());
  for (std::uint32_t part = 0; part < count; ++part) {
    msg::QueryReply& reply = parts[part];
    reply.to = query.header.sender;
    reply.request = query.request;
    reply.part = part;
    reply.parts = count;
    context_.out.send(std::move(reply));
  }
}

std::string Answers::occupies(const RobotId& robot) const {
  const storage::PutOccupancy* const held = traffic_.held(robot);
  if (held == nullptr) return {};
  const std::string from = to_string(held->held.places[held->from]);
  return held->from == held->to ? from : from + " to " + to_string(held->held.places[held->to]);
}

msg::RobotRow Answers::standing(const Robot& robot, SteadyTime now) const {
  msg::RobotRow row;
  if (robot.state) row.state = *robot.state;
  row.description.name = robot.name;
  row.description.header.sender = robot.id;
  row.silent_s = seconds(now - robot.heard);
  row.is_heard = !robot.silent;
  row.is_twin = robot.incarnations.twins();
  row.is_deaf = !robot.silent && robot.directions.is_deaf();
  row.clock_skew_s = robot.skew.seconds_ahead().value_or(0.0);
  if (const Wait* const wait = standstills_.wait_of(robot.id)) {
    row.wait = {.at = wait->at,
                .needs = wait->needs,
                .held_by = {wait->held_by.begin(), wait->held_by.end()},
                .since = wait->since.wall,
                .rule = wait->rule};
  }
  row.standstill = clipped(standstills_.text_of(robot.id));
  return row;
}

Answers::Parts Answers::robots(SteadyTime now) const {
  Parts parts;
  for (const auto& [id, robot] : fleet_.robots()) {
    if (parts.empty() || parts.back().robots.size() == kRobotsInPart) parts.emplace_back();
    msg::RobotRow row = standing(robot, now);
    if (robot.description) row.description = *robot.description;
    row.description.name = robot.name;
    row.description.header.sender = id;
    row.vendor = robot.vendor;
    row.software = robot.software;
    row.occupies = occupies(id);
    row.window_bytes = robot.window_bytes;
    row.content_bytes = robot.content_bytes;
    row.messages_heard = robot.reception.heard();
    row.messages_missed = robot.reception.missed();
    row.held_by = robot.held_by;
    row.is_window_current = robot.state && window_publisher_.is_current(id, robot.state->window_digest);
    if (robot.power) row.power = *robot.power;
    put_on_plan(site_frames_, row);
    parts.back().robots.push_back(std::move(row));
  }
  return parts;
}

Answers::Parts Answers::alarms(Now now) {
  alarms_seen_ = now.steady;
  std::vector<msg::RobotRow> rows;
  for (const auto& [id, robot] : fleet_.robots()) rows.push_back(standing(robot, now.steady));
  Parts parts;
  for (msg::Alarm& alarm : alarm_watch_.seen(alarms_of(info(), rows, now.wall), context_.counters, now)) {
    if (parts.empty() || parts.back().alarms.size() == kAlarmsInPart) parts.emplace_back();
    alarm.detail = clipped(std::move(alarm.detail));
    parts.back().alarms.push_back(std::move(alarm));
  }
  return parts;
}

void Answers::tick(Now now) {
  past_maps_.tick(now.steady);
  // Looked at now and then, so that it is known since when something is wrong.
  if (!alarms_seen_ || now.steady - *alarms_seen_ >= kBetweenAlarms) std::ignore = alarms(now);
}

Answers::Parts Answers::goals(const msg::Query& query) const {
  std::vector<const Goal*> wanted;
  const GoalBook& book = dispatcher_.book();
  for (const auto& [id, goal] : book.goals()) {
    if (!query.goal || query.goal == id) wanted.push_back(&goal);
  }
  std::sort(wanted.begin(), wanted.end(), [](const Goal* a, const Goal* b) { return a->number < b->number; });
  if (wanted.size() > kMostGoals) wanted.erase(wanted.begin(), wanted.end() - kMostGoals);
  Parts parts;
  std::size_t weight = 0;
  for (const Goal* const goal : wanted) {
    const Route* const route = book.route(goal->id);
    const std::size_t more = 1 + goal->history.size() + (route != nullptr ? route->places.size() : 0);
    if (parts.empty() || weight + more > kGoalWeightOfPart) {
      parts.emplace_back();
      weight = 0;
    }
    weight += more;
    parts.back().goals.push_back(*goal);
    if (route != nullptr) parts.back().routes.push_back(*route);
    if (const std::optional<msg::Arrival> arrival = dispatcher_.arrival(*goal)) {
      parts.back().arrivals.push_back(*arrival);
    }
  }
  return parts;
}

Result<Answers::Parts> Answers::events(const msg::Query& query) const {
  RobotId robot;
  if (!query.robot.empty()) {
    const Result<RobotId> id = fleet_.by_name(query.robot);
    if (!id) return fail(id.error());
    robot = *id;
  }
  const storage::EventFilter filter = {
      .goal = query.goal, .robot = robot, .kind = query.event_kind, .since = query.since, .after = query.after_event};
  const std::size_t most = query.most == 0 ? kMostEvents : std::min<std::size_t>(query.most, kMostEvents);
  const Result<storage::EventPage> page = context_.store.events(filter, most);
  if (!page) return fail(page.error());
  Parts parts(1);
  for (const msg::Event& event : page->events) {
    if (parts.back().events.size() == kEventsInPart) parts.emplace_back();
    parts.back().events.push_back(event);
  }
  for (msg::QueryReply& part : parts) {
    part.oldest_event = page->oldest;
    part.newest_event = page->newest;
  }
  return parts;
}

Result<Answers::Parts> Answers::log(const msg::Query& query) const {
  Result<std::vector<msg::RevisionNote>> notes =
      context_.store.log(query.newest, std::min<std::size_t>(query.most, kMostRevisions));
  if (!notes) return fail(notes.error());
  Parts parts;
  for (msg::RevisionNote& note : *notes) {
    if (parts.empty() || parts.back().log.size() == kRevisionsInPart) parts.emplace_back();
    note.cause = clipped(std::move(note.cause));
    parts.back().log.push_back(std::move(note));
  }
  return parts;
}

Result<Answers::Parts> Answers::experiences() const {
  const Result<std::map<ExperienceId, WallTime>> begun = context_.store.begun();
  if (!begun) return fail(begun.error());
  Parts parts;
  std::size_t weight = 0;
  for (msg::ExperienceRow& row : experience_rows(context_.snapshots.current(), *begun)) {
    const std::size_t more = kRowWeight + row.labels.size() + row.joined.size();
    if (parts.empty() || weight + more > kExperienceWeightOfPart) {
      parts.emplace_back();
      weight = 0;
    }
    weight += more;
    parts.back().experiences.push_back(std::move(row));
  }
  add_awaited_labels(parts);
  return parts;
}

void Answers::add_awaited_labels(Parts& parts) const {
  static_assert(AwaitedLabels::kMost <= kAwaitedLabelsInPart);
  const std::vector<AwaitedLabels::Awaited> all = awaited_labels_.all();
  if (all.empty()) return;
  parts.emplace_back();
  for (const AwaitedLabels::Awaited& awaited : all) {
    const AwaitedLabels::Label& label = awaited.label;
    parts.back().awaited_labels.push_back(
        {.label = label.label, .place = label.place, .robot = label.robot, .who = label.who});
  }
}

Answers::Parts Answers::rules() const {
  const Snapshot& snapshot = context_.snapshots.current();
  Parts parts;
  for (const auto& [name, rule] : snapshot.rules()) {
    if (parts.empty() || parts.back().rules.size() == kRulesInPart) parts.emplace_back();
    RuleExtent extent = extent_of(snapshot, rule);
    parts.back().rules.push_back({.rule = rule,
                                  .places = static_cast<std::uint32_t>(extent.places.size()),
                                  .problem = clipped(std::move(extent.problem))});
  }
  return parts;
}

Answers::Parts Answers::registrations() const {
  Parts parts;
  for (msg::RegistrationRow& row : registration_rows(context_.snapshots.current(), site_frames_)) {
    parts.emplace_back();
    parts.back().registrations.push_back(std::move(row));
  }
  return parts;
}

Result<Answers::Parts> Answers::network(const msg::Query& query, SteadyTime now) {
  const Result<std::shared_ptr<const Snapshot>> network = past_maps_.at(query.at, now);
  if (!network) return fail(network.error());
  std::shared_ptr<const Snapshot> other;
  if (query.apart_from != Revision{}) {
    const Result<std::shared_ptr<const Snapshot>> found = past_maps_.at(query.apart_from, now);
    if (!found) return fail(found.error());
    other = *found;
  }
  const NetworkPage page = page_of(**network, other.get(), query.after, kEntitiesOfPage);
  Parts parts;
  for (NetworkPage& piece : pieces_of(page, msg::kPatchEntities)) {
    parts.emplace_back();
    parts.back().network = std::move(piece);
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
  info.unjoined = clipped(unjoined_.warning());
  if (context_.writer.stopped()) info.stopped = clipped(context_.writer.stopped()->message);
  return info;
}

}  // namespace weft::server
