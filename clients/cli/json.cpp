#include "clients/cli/json.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"

namespace weft::cli {

using nlohmann::json;

std::string name_of(const Names& names, const RobotId& robot) {
  const auto found = names.find(robot);
  return found == names.end() || found->second.empty() ? to_string(robot) : found->second;
}

double duration_s(const Goal& goal, WallTime now) {
  if (goal.history.empty()) return 0.0;
  const WallTime end = is_terminal(goal.state) ? goal.history.back().at : now;
  return std::max(0.0, seconds(end - goal.history.front().at));
}

json to_json(const Pose2& pose) {
  return {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}};
}

json to_json(const std::vector<Diagnostic>& diagnostics) {
  json list = json::array();
  for (const Diagnostic& one : diagnostics)
    list.push_back({{"name", one.name}, {"value", one.value}, {"sigma", one.sigma}, {"bound", one.bound}});
  return list;
}

json to_json(const msg::RobotWait& wait, const std::string& robot, const Names& names) {
  json holders = json::array();
  for (const RobotId& holder : wait.held_by) holders.push_back(name_of(names, holder));
  return {{"robot", robot},
          {"at", to_string(wait.at)},
          {"needs", wait.needs ? json(to_string(wait.needs)) : json()},
          {"held_by", std::move(holders)},
          {"rule", wait.rule.empty() ? json() : json(wait.rule)},
          {"since", iso_time(wait.since)}};
}

json to_json(const msg::RobotPower& power) {
  json object = {{"share", power.share}, {"charging", power.is_charging}};
  object["minutes"] = power.minutes ? json(*power.minutes) : json();
  return object;
}

json to_json(const msg::RobotRow& row, const Names& names) {
  const msg::RobotState& state = row.state;
  json object = {{"name", row.description.name},
                 {"id", to_string(row.description.header.sender)},
                 {"body", row.description.body},
                 {"methods", row.description.methods},
                 {"vendor", row.vendor},
                 {"software", row.software},
                 {"mode", msg::to_string(state.mode)},
                 {"reason", state.reason},
                 {"localised", state.localised},
                 {"blind_m", state.blind_m},
                 {"speed_m_s", state.speed_m_s},
                 {"frame", state.frame},
                 {"window_revision", state.window_revision.value},
                 {"contents_missing", state.contents_missing},
                 {"diagnostics", to_json(state.diagnostics)},
                 {"memory_bytes", state.memory_bytes},
                 {"memory_cap_bytes", state.memory_cap_bytes},
                 {"window_bytes_sent", row.window_bytes},
                 {"content_bytes_sent", row.content_bytes},
                 {"silent_s", row.silent_s},
                 {"heard", row.is_heard},
                 {"clock_skew_s", row.clock_skew_s},
                 {"occupies", row.occupies}};
  object["place"] = state.place ? json(to_string(state.place)) : json();
  object["place_from_robot"] = state.place ? to_json(planar(state.place_from_robot)) : json();
  object["experience"] = state.experience ? json(to_string(state.experience)) : json();
  object["goal"] = state.goal ? json(to_string(state.goal)) : json();
  object["waits"] = row.wait.at ? to_json(row.wait, row.description.name, names) : json();
  object["safety"] = to_string(state.safety);
  object["knows_limits"] = row.description.knows_limits;
  object["power"] = row.power.header.sender ? to_json(row.power) : json();
  object["held"] = row.held_by.empty() ? json() : json(row.held_by);
  object["on_plan"] = row.plan.empty() ? json() : json{{"plan", row.plan}, {"pose", to_json(row.plan_from_robot)}};
  object["standstill"] = row.standstill.empty() ? json() : json(row.standstill);
  object["spool_refuses"] = row.state.spool_refuses.empty() ? json() : json(row.state.spool_refuses);
  object["twins"] = row.is_twin;
  object["deaf"] = row.is_deaf;
  object["server_unheard_s"] = row.state.server_unheard_s;
  object["window_current"] = row.is_window_current;
  return object;
}

json to_json(const GoalEvent& event) {
  return {{"at", iso_time(event.at)}, {"state", to_string(event.state)}, {"cause", event.cause}, {"who", event.who}};
}

json to_json(const Goal& goal, const Route* route, const Names& names, WallTime now) {
  json places = json::array();
  if (route != nullptr) {
    for (const PlaceId& place : route->places) places.push_back(to_string(place));
  }
  json history = json::array();
  for (const GoalEvent& event : goal.history) {
    history.push_back(to_json(event));
  }
  json object = {{"id", to_string(goal.id)},
                 {"number", goal.number},
                 {"to", goal.label},
                 {"place", goal.to.experience ? json(to_string(goal.to)) : json()},
                 {"state", to_string(goal.state)},
                 {"kind", to_string(goal.kind)},
                 {"priority", goal.priority},
                 {"no_return", goal.no_return},
                 {"route", std::move(places)},
                 {"route_version", goal.route_version},
                 {"duration_s", duration_s(goal, now)},
                 {"history", std::move(history)}};
  object["robot"] = goal.robot.has_value() ? json(name_of(names, *goal.robot)) : json();
  object["wanted"] = goal.wanted.has_value() ? json(name_of(names, *goal.wanted)) : json();
  object["released"] = route != nullptr ? json(route->released) : json();
  return object;
}

std::string minutes_text(double time_s) {
  const auto whole = static_cast<std::uint64_t>(std::llround(std::max(0.0, time_s)));
  const std::uint64_t minutes = whole / 60;
  const std::string rest = std::to_string(whole % 60) + " s";
  if (minutes == 0) return rest;
  if (minutes < 60) return std::to_string(minutes) + " min" + (whole % 60 > 0 ? " " + rest : "");
  return std::to_string(minutes / 60) + " h" + (minutes % 60 > 0 ? " " + std::to_string(minutes % 60) + " min" : "");
}

std::string to_text(const msg::Arrival& arrival) {
  return "arrives in " + minutes_text(arrival.in_s) + " (" + minutes_text(arrival.soonest_s) + " to " +
         minutes_text(arrival.latest_s) + ")";
}

json to_json(const msg::Arrival& arrival) {
  return {{"in_s", arrival.in_s}, {"soonest_s", arrival.soonest_s}, {"latest_s", arrival.latest_s}};
}

json to_json(const msg::Event& event, const Names& names) {
  json object = {{"at", iso_time(event.at)}, {"kind", event.kind}, {"cause", event.cause}, {"who", event.who}};
  object["robot"] = event.robot ? json(name_of(names, event.robot)) : json();
  object["goal"] = event.goal ? json(to_string(event.goal)) : json();
  object["number"] = event.number != 0 ? json(event.number) : json();
  return object;
}

json to_json(const msg::MapInfo& info) {
  json counters = json::object();
  for (const auto& [what, times] : info.counters) counters[what] = times;
  return {{"revision", info.revision.value},
          {"epoch", info.epoch.value},
          {"experiences", info.experiences},
          {"places", info.places},
          {"stitches", info.stitches},
          {"contents", info.contents},
          {"content_bytes", info.content_bytes},
          {"batches_acknowledged", info.batches_acknowledged},
          {"batches_refused", info.batches_refused},
          {"disk_free_bytes", info.disk_free_bytes},
          {"software", info.software},
          {"vendor", info.vendor},
          {"engine", info.engine},
          {"stopped", info.stopped},
          {"unjoined", info.unjoined},
          {"counters", std::move(counters)}};
}

json to_json(const Window& network, const Names& names, const RunNames& runs) {
  json places = json::array();
  std::map<ExperienceId, json> experiences;
  for (const auto& [id, place] : network.places) {
    places.push_back({{"id", to_string(id)},
                      {"experience", to_string(id.experience)},
                      {"index", id.index},
                      {"robot", name_of(names, place.robot)},
                      {"frame", place.frame},
                      {"method", place.method},
                      {"content", to_string(place.content.hash)},
                      {"content_bytes", place.content.size}});
    json& experience = experiences[id.experience];
    if (experience.is_null()) {
      const auto run = runs.find(id.experience);
      experience = {{"id", to_string(id.experience)},
                    {"name", run == runs.end() ? std::string() : run->second},
                    {"robot", name_of(names, place.robot)},
                    {"places", 0}};
    }
    experience["places"] = experience["places"].get<std::uint64_t>() + 1;
  }
  json edges = json::array();
  for (const auto& [id, edge] : network.edges) {
    static constexpr std::array<const char*, 4> kDrivable = {"none", "a_to_b", "b_to_a", "both"};
    edges.push_back({{"a", to_string(id.a)},
                     {"b", to_string(id.b)},
                     {"a_from_b", to_json(planar(edge.a_from_b))},
                     {"origin", to_string(edge.origin)},
                     {"method", edge.method},
                     {"drivable", kDrivable[static_cast<std::size_t>(edge.drivable) % kDrivable.size()]},
                     {"inliers", edge.inliers},
                     {"overlap", edge.overlap}});
  }
  json labels = json::object();
  for (const auto& [label, place] : network.labels) labels[label] = to_string(place);
  json listed = json::array();
  for (auto& [id, experience] : experiences) listed.push_back(std::move(experience));
  return {{"revision", network.revision.value},
          {"experiences", std::move(listed)},
          {"places", std::move(places)},
          {"edges", std::move(edges)},
          {"labels", std::move(labels)}};
}

}  // namespace weft::cli
