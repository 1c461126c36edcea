#include "clients/evaluate/floor/replay.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "agents/bodies/replay/replay_body.hpp"
#include "agents/perception/camera_model.hpp"
#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/alignment.hpp"
#include "clients/evaluate/floor/driven_robot.hpp"
#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/recorded_truth.hpp"
#include "clients/evaluate/study_file.hpp"
#include "clients/evaluate/table.hpp"
#include "clients/evaluate/taught_map.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

constexpr ExperienceId kMapped{1};
constexpr RobotId kRecorder{{1}};
constexpr std::size_t kProgressEvery = 500;  // images

Result<DrivenRobot> robot_of(const std::filesystem::path& recording, const ReplayOptions& options,
                             const Surroundings& around) {
  replay::ReplayBodyConfig config;
  config.folder = recording.string();
  config.camera = options.camera;
  if (const auto& mount = options.mount) {
    config.robot_from_camera = downward_mount(mount->forward_m, mount->left_m, mount->height_m,
                                              mount->pitch_deg * std::numbers::pi / 180.0, 0.0, 0.0);
  }
  config.warn = [&around](const std::string& what) { around.progress << "weft-evaluate: " << what << '\n'; };
  Result<std::unique_ptr<Body>> body = replay::make_replay_body(config);
  if (!body) return fail(body.error());
  return DrivenRobot::of(std::move(*body));
}

struct Pass {
  Trace trace;
  double seconds = 0.0;
};

/// Plays a recording to its end. `each` takes every sample; none: stopped.
template <class Each>
Result<std::optional<Pass>> play(DrivenRobot& robot, const TaughtMap& map, const std::string& what,
                                 const Surroundings& around, const Each& each) {
  const double began_s = around.steady_s();
  for (std::size_t count = 1;; ++count) {
    if (around.asked_to_stop()) return std::optional<Pass>();
    const Result<DrivenRobot::Stepped> stepped = robot.step(map.view());
    // A recording that is over says so like a broken camera; which of the two, its words tell.
    if (!stepped && count == 1) return fail(stepped.error());
    if (!stepped) break;
    if (const Result<void> taken = each(*stepped); !taken) return fail(taken.error());
    if (count % kProgressEvery != 0) continue;
    const double rate = static_cast<double>(count) / std::max(1e-9, around.steady_s() - began_s);
    around.progress << what << ": " << count << " images, " << cell(rate, 0) << " a second\n" << std::flush;
  }
  Result<Trace> trace = robot.finish();
  if (!trace) return fail(trace.error());
  return std::optional(Pass{std::move(*trace), around.steady_s() - began_s});
}

Result<std::optional<Pass>> map_all(const ReplayOptions& options, const Surroundings& around, TaughtMap& map) {
  Result<DrivenRobot> robot = robot_of(options.recording, options, around);
  if (!robot) return fail(robot.error());
  robot->navigator().begin_teach({kMapped, kRecorder});
  return play(*robot, map, "mapping", around, [&](const DrivenRobot::Stepped& stepped) {
    return map.take(kMapped, kRecorder, "floor", stepped.navigated.kept);
  });
}

Result<std::optional<Pass>> localise_all(const ReplayOptions& options, const Surroundings& around,
                                         const TaughtMap& map, const Trace& mapped) {
  const bool is_same = options.query.empty();
  Result<DrivenRobot> robot = robot_of(is_same ? options.recording : options.query, options, around);
  if (!robot) return fail(robot.error());
  if (is_same) {
    // A view that has become a place would be compared with itself.
    std::set<std::uint64_t> places;
    for (const Moment& moment : mapped.moments) {
      if (moment.kept) places.insert(moment.frame);
    }
    robot->leave_out(std::move(places));
  }
  robot->navigator().seek(std::nullopt);
  return play(*robot, map, "localising", around, [](const DrivenRobot::Stepped&) { return Result<void>(); });
}

double odometry_m(const Trace& trace) {
  double sum = 0.0;
  for (std::size_t i = 1; i < trace.moments.size(); ++i) {
    const Pose2 step = trace.moments[i - 1].start_from_robot.inverse() * trace.moments[i].start_from_robot;
    sum += std::hypot(step.x, step.y);
  }
  return sum;
}

double seen_percent(const Trace& trace) {
  const auto seen = std::count_if(trace.moments.begin(), trace.moments.end(), [](const Moment& m) { return m.seen; });
  return 100.0 * static_cast<double>(seen) / static_cast<double>(trace.moments.size());
}

/// Returns the longest way by odometry between two fixes, in metres, both ends of the trace included.
double longest_between_fixes_m(const Trace& trace) {
  double longest = 0.0;
  double since = 0.0;
  for (std::size_t i = 1; i < trace.moments.size(); ++i) {
    const Pose2 step = trace.moments[i - 1].start_from_robot.inverse() * trace.moments[i].start_from_robot;
    since += std::hypot(step.x, step.y);
    longest = std::max(longest, since);
    if (trace.moments[i].fix) since = 0.0;
  }
  return longest;
}

struct Number {
  std::string name;
  double value;
  int digits;
};

std::vector<Number> numbers_of(const Pass& mapped, const Pass& localised, const TaughtMap& map,
                               const std::optional<Associated>& map_truth, const std::optional<Trace>& query_truth) {
  const auto images = static_cast<double>(mapped.trace.moments.size());
  std::vector<Number> numbers = {
      {"images mapped", images, 0},
      {"of them vision took part in, %", seen_percent(mapped.trace), 1},
      {"driven by odometry, m", odometry_m(mapped.trace), 2},
      {"places kept", static_cast<double>(map.snapshot().place_count()), 0},
      {"stitches to where it had been before", static_cast<double>(map.snapshot().stitch_count()), 0},
      {"images a second, mapping", images / std::max(1e-9, mapped.seconds), 0},
      {"images localised", static_cast<double>(localised.trace.moments.size()), 0},
      {"fixes", fixes(localised.trace), 0},
      {"longest way without a fix, by odometry, m", longest_between_fixes_m(localised.trace), 2},
      {"images a second, localising",
       static_cast<double>(localised.trace.moments.size()) / std::max(1e-9, localised.seconds), 0},
  };
  if (map_truth) {
    const SpeedError error = speed_error(map_truth->trace);
    numbers.push_back({"images with a truth", static_cast<double>(map_truth->trace.moments.size()), 0});
    numbers.push_back({"speed error, %", error.percent, 2});
    numbers.push_back({"position after alignment, RMSE, m", map_truth->rmse_m, 3});
    numbers.push_back({"truth out of its plane, RMS, m", map_truth->out_of_plane_m, 3});
    numbers.push_back({"truth's body turned against the robot, degrees (taken out)",
                       map_truth->heading_offset_rad * 180.0 / std::numbers::pi, 2});
  }
  if (map_truth && query_truth) {
    const PlaceSet places = places_of(map_truth->trace);
    Trace judged = *query_truth;  // fixes on places that have a truth
    for (Moment& moment : judged.moments) {
      if (moment.fix && !places.site_from_place.contains(moment.fix->place)) moment.fix.reset();
    }
    const std::vector<double> blind = blind_distances(judged, places.site_from_place);
    numbers.push_back({"fixes with a truth", fixes(judged), 0});
    numbers.push_back({"of them wrong (> 0.10 m or > 3 degrees)", wrong_fixes(judged, places.site_from_place), 0});
    numbers.push_back({"longest true way without a right fix, m", *std::max_element(blind.begin(), blind.end()), 2});
  }
  return numbers;
}

nlohmann::json path_of(const Trace& trace, Pose2 Moment::*pose) {
  nlohmann::json points = nlohmann::json::array();
  for (const Moment& moment : trace.moments) points.push_back({(moment.*pose).x, (moment.*pose).y});
  return points;
}

/// Writes both passes for the picture: seconds since the first image of each, metres.
Result<void> write_passes(const ReplayOptions& options, const Pass& mapped, const Pass& localised,
                          const std::optional<Associated>& truth) {
  nlohmann::json series = {{"recording", options.recording.filename().string()},
                           {"about", "method floor, camera " + options.camera},
                           {"odometry", path_of(mapped.trace, &Moment::start_from_robot)}};
  for (const char* const name : {"trajectory", "matches", "fixes", "speeds"}) series[name] = nlohmann::json::array();
  const double began_s = mapped.trace.moments.front().sensor_s;
  for (const Moment& moment : mapped.trace.moments)
    series["matches"].push_back({moment.sensor_s - began_s, moment.matches});
  const double query_began_s = localised.trace.moments.front().sensor_s;
  for (const Moment& moment : localised.trace.moments)
    if (moment.fix) series["fixes"].push_back({moment.sensor_s - query_began_s, moment.fix->place.index});
  if (truth) {
    series["trajectory"] = path_of(truth->trace, &Moment::site_from_robot);
    for (const SpeedWindow& window : speed_windows(truth->trace))
      series["speeds"].push_back({window.true_s - began_s, window.v_m_s, window.v_true_m_s});
  }
  return write_series(options.out, "replay", series);
}

Result<void> report(const ReplayOptions& options, const std::vector<Number>& numbers, const Pass& localised,
                    const Surroundings& around) {
  nlohmann::json document = {{"recording", options.recording.string()}, {"query", options.query.string()}};
  std::vector<std::vector<std::string>> rows = {{"replayed", ""}};
  for (const Number& number : numbers) {
    document["numbers"][number.name] = number.value;
    rows.push_back({number.name, cell(number.value, number.digits)});
  }
  for (const auto& [reason, count] : localised.trace.refusals) {
    document["refusals"][reason] = count;
    rows.push_back({"refused while localising: " + reason, std::to_string(count)});
  }
  if (const Result<void> kept = write_text(options.out / "replay.json", document.dump(1) + "\n"); !kept) return kept;
  const std::vector<std::string> pictures = draw_pictures("replay", options.out, around);
  around.out << markdown_table(rows, 1) << std::flush;
  around.progress << "weft-evaluate: replay.json and " << words_of(pictures) << " are in " << options.out.string()
                  << '\n';
  return {};
}

}  // namespace

Result<Ended> replay_floor(const ReplayOptions& options, const Surroundings& around) {
  const auto trajectory = recorded_truth(options.recording, options.truth);
  if (!trajectory) return fail(trajectory.error());
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return fail(ErrorCode::unavailable, options.out.string() + ": " + problem.message());
  TaughtMap map;
  const Result<std::optional<Pass>> mapped = map_all(options, around, map);
  if (!mapped) return fail(mapped.error());
  if (!*mapped) return Ended::stopped;
  const Result<std::optional<Pass>> localised = localise_all(options, around, map, (*mapped)->trace);
  if (!localised) return fail(localised.error());
  if (!*localised) return Ended::stopped;
  std::optional<Associated> map_truth;
  std::optional<Trace> query_truth;
  if (*trajectory) {
    map_truth = associate((*mapped)->trace, **trajectory);
    if (map_truth && options.query.empty()) {
      query_truth = in_frame_of(*map_truth, (*localised)->trace, **trajectory);
    }
  }
  const std::vector<Number> numbers = numbers_of(**mapped, **localised, map, map_truth, query_truth);
  if (const auto kept = write_passes(options, **mapped, **localised, map_truth); !kept) return fail(kept.error());
  if (const Result<void> told = report(options, numbers, **localised, around); !told) return fail(told.error());
  return Ended::complete;
}

}  // namespace weft::evaluate::floor
