#include <algorithm>

#include "clients/cli/picture.hpp"
#include "clients/cli/run_colour.hpp"

namespace weft::cli {
namespace {

using Sample = LegendLine::Sample;

/// Returns who taught the run: the robot's name, else the beginning of its id.
std::string teacher(const Subject& subject, const Run& run) {
  const auto found = subject.robot_names.find(run.robot);
  const bool is_named = found != subject.robot_names.end() && !found->second.empty();
  return is_named ? found->second : to_string(run.robot).substr(0, 8);
}

std::vector<LegendLine> run_lines(const Subject& subject, const std::vector<Run>& runs) {
  std::vector<LegendLine> lines;
  const std::size_t listed = std::min(runs.size(), kMostRunsListed);
  for (std::size_t i = 0; i < listed; ++i) {
    const Run& run = runs[i];
    lines.push_back({Sample::run,
                     "run " + shown_run(run.id, subject.run_names) + ": " + how_many(run.places, "place") + ", " +
                         (run.is_imported ? "imported" : "taught by " + teacher(subject, run)),
                     run_colour(run.id), kThickRun});
  }
  if (runs.size() == listed) return lines;
  std::size_t places = 0;
  for (std::size_t i = listed; i < runs.size(); ++i) places += runs[i].places;
  lines.push_back({Sample::none,
                   "and " + how_many(runs.size() - listed, "shorter run") + " with " + how_many(places, "place"),
                   kQuiet});
  return lines;
}

void add_network_lines(const Subject& subject, std::vector<LegendLine>& lines) {
  bool has_blind = false;
  bool has_stitch = false;
  bool has_met = false;
  for (const auto& [id, edge] : subject.network.edges) {
    has_blind |= edge.origin == Origin::blind;
    has_stitch |= edge.origin == Origin::stitch && edge.drivable != Drivable::none;
    has_met |= edge.origin == Origin::stitch && edge.drivable == Drivable::none;
  }
  if (has_blind) lines.push_back({Sample::line, "joined by odometry alone: nothing was seen", kInk, kThickRun, true});
  if (has_stitch) lines.push_back({Sample::line, "stitch: the same spot, seen twice", kStitch, kThickStitch});
  if (has_met) lines.push_back({Sample::line, "thin stitch: nobody can change over there", kStitch, kThinStitch});
  const std::size_t labels = subject.network.labels.size();
  if (labels > 0) lines.push_back({Sample::label, "labelled place, with its label"});
  if (labels > kMostLabels)
    lines.push_back(
        {Sample::none, how_many(labels - kMostLabels, "labelled place") + " without their labels", kQuiet});
}

void add_robot_lines(const RobotsOnMap& robots, std::vector<LegendLine>& lines) {
  const auto any = [&](auto&& has) { return std::ranges::any_of(robots.drawn, has); };
  const auto looks = [&](RobotMark::Look look) {
    return any([&](const RobotMark& robot) { return robot.drawing_from_robot.has_value() && robot.look == look; });
  };
  if (looks(RobotMark::Look::heard)) lines.push_back({Sample::robot, "robot; its tip is ahead"});
  if (looks(RobotMark::Look::lost))
    lines.push_back({Sample::robot_lost, "robot that does not know where it is: where it last did"});
  if (looks(RobotMark::Look::silent))
    lines.push_back({Sample::robot_silent, "robot that is not heard: where it last said it was"});
  if (any([](const RobotMark& robot) { return !robot.held.empty(); }))
    lines.push_back({Sample::held, "held by a robot, as wide as its footprint: others wait"});
  if (any([](const RobotMark& robot) { return !robot.held.empty() && !robot.is_held_whole; }))
    lines.push_back({Sample::none, "two spots of one robot: it holds the way between them too", kQuiet});
  if (any([](const RobotMark& robot) { return !robot.ahead.empty(); })) {
    lines.push_back({Sample::ahead, "rest of a route, not released yet", kInk, 2.0, true});
    lines.push_back({Sample::goal, "a route's goal"});
  }
  constexpr std::size_t listed = 4;
  for (std::size_t i = 0; i < std::min(listed, robots.not_drawn.size()); ++i) {
    const RobotsOnMap::NotDrawn& robot = robots.not_drawn[i];
    lines.push_back({Sample::none, "not drawn: " + robot.name + ", " + robot.why, kQuiet});
  }
  if (robots.not_drawn.size() > listed)
    lines.push_back({Sample::none, how_many(robots.not_drawn.size() - listed, "more robot") + " not drawn", kQuiet});
  if (robots.drawn.empty() && robots.not_drawn.empty()) lines.push_back({Sample::none, "no robot is known", kQuiet});
}

}  // namespace

Legend legend_of(const Subject& subject, const std::vector<Run>& runs) {
  Legend legend;
  legend.runs = run_lines(subject, runs);
  add_network_lines(subject, legend.marks);
  if (subject.robots.has_value()) add_robot_lines(*subject.robots, legend.marks);
  if (subject.ground.has_value())
    legend.marks.push_back({Sample::none, "floor plan: walls dark, not known grey", kQuiet});
  return legend;
}

}  // namespace weft::cli
