#include "clients/cli/map_draw.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "clients/cli/draw.hpp"
#include "clients/cli/run_colour.hpp"
#include "clients/cli/run_list.hpp"

namespace weft::cli {
namespace {

/// Returns the colour as "#rrggbb".
std::string to_text(const Colour& colour) {
  std::array<char, 8> text{};
  const auto byte = [](double share) { return static_cast<unsigned>(std::lround(255.0 * share)); };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(colour.r), byte(colour.g), byte(colour.b));
  return text.data();
}

nlohmann::json document_of(const Subject& subject) {
  nlohmann::json document = {{"runs", nlohmann::json::array()}};
  for (const Run& run : runs_of(subject.network)) {
    const auto name = subject.run_names.find(run.id);
    document["runs"].push_back({{"experience", to_string(run.id)},
                                {"name", name != subject.run_names.end() ? nlohmann::json(name->second) : nullptr},
                                {"places", run.places},
                                {"colour", to_text(run_colour(run.id))}});
  }
  if (!subject.robots.has_value()) return document;
  nlohmann::json drawn = nlohmann::json::array();
  for (const RobotMark& robot : subject.robots->drawn) {
    if (robot.drawing_from_robot.has_value()) drawn.push_back(robot.name);
  }
  nlohmann::json not_drawn = nlohmann::json::array();
  for (const auto& [name, why] : subject.robots->not_drawn) not_drawn.push_back({{"name", name}, {"why", why}});
  document["robots"] = {{"drawn", std::move(drawn)}, {"not_drawn", std::move(not_drawn)}};
  return document;
}

Result<RobotsOnMap> find_robots(Session& session, const Layout& layout, const std::vector<msg::RobotRow>& rows,
                                const Invocation& invocation) {
  msg::Query query;
  query.kind = msg::Query::Kind::goals;
  const Result<msg::QueryReply> goals = session.query(query, patience(invocation));
  if (!goals) return fail(goals.error());
  return robots_on_map(layout, rows, goals->goals, goals->routes);
}

Result<Subject> subject_of(Session& session, Laid laid, const std::vector<msg::RobotRow>& rows,
                           const Invocation& invocation, const Output& output) {
  Subject subject;
  subject.robot_names = names_of(rows);
  if (!invocation.floor_plan.empty()) {
    Result<formats::FloorPlan> plan = read_floor_plan(invocation.floor_plan, output.err);
    if (!plan) return fail(plan.error());
    subject.ground = Ground{*std::move(plan), "upon " + invocation.floor_plan + ", " + laid.caption};
  }
  if (invocation.draws_robots) {
    Result<RobotsOnMap> robots = find_robots(session, laid.layout, rows, invocation);
    if (!robots) return fail(robots.error());
    subject.robots = *std::move(robots);
  }
  Result<RunNames> names = query_run_names(session, patience(invocation));
  if (!names) return fail(names.error());
  subject.run_names = *std::move(names);
  subject.network = std::move(laid.network);
  subject.layout = std::move(laid.layout);
  return subject;
}

}  // namespace

Exit run_map_draw(Session& session, Laid laid, const std::vector<msg::RobotRow>& robots, const Invocation& invocation,
                  const Output& output) {
  const std::string caption = laid.caption;
  const Result<Subject> subject = subject_of(session, std::move(laid), robots, invocation, output);
  if (!subject) return report(subject.error(), invocation.json, output);
  if (const Result<void> drawn = draw(*subject, invocation.file); !drawn)
    return report(drawn.error(), invocation.json, output);
  say_written(subject->network, caption, document_of(*subject), invocation, output);
  if (invocation.json || !subject->robots.has_value()) return Exit::done;
  for (const auto& [name, why] : subject->robots->not_drawn)
    output.out << "not drawn: " << name << ", " << why << '\n';
  return Exit::done;
}

void say_written(const Window& network, const std::string& caption, const nlohmann::json& more,
                 const Invocation& invocation, const Output& output) {
  if (!invocation.json) {
    output.out << invocation.file << ": revision " << network.revision.value << ", " << network.places.size()
               << " places" << (caption.empty() ? "" : ", ") << caption << '\n';
    return;
  }
  nlohmann::json document = {{"file", invocation.file},
                             {"revision", network.revision.value},
                             {"places", network.places.size()},
                             {"edges", network.edges.size()}};
  if (!caption.empty()) document[invocation.anchors.empty() ? "on_plan" : "anchors"] = caption;
  document.update(more);
  output.out << printed(document) << '\n';
}

}  // namespace weft::cli
