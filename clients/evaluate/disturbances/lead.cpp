#include "clients/evaluate/disturbances/lead.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/floor/floor.hpp"

namespace weft::evaluate {
namespace {

using namespace agents;

constexpr double kPlaceEveryM = 0.25;    // taught
constexpr double kAttemptEveryM = 0.10;  // looked for
constexpr double kNearM = 0.30;          // a view farther from all places is not asked for a fix
constexpr double kNearRad = 0.50;

struct KeptPlace {
  std::size_t frame = 0;
  std::optional<FloorContent> content;  ///< none: refused
};
struct Run {
  Floor floor;  ///< as its agent would have it
  std::vector<Frame> frames;
  std::vector<KeptPlace> kept;
};

/// Reads the true poses of the run's frames, dropped ones included, in the order of driving.
Result<void> add_truth(const std::filesystem::path& file, Run& run) {
  std::ifstream in(file);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line); ++count) {
    const auto row = nlohmann::json::parse(line, nullptr, false);
    if (row.is_discarded() || count >= run.frames.size()) break;
    run.frames[count].site_from_robot = {row["x"], row["y"], row["heading"]};
    run.frames[count].true_s = row["t"];
  }
  if (count == run.frames.size()) return {};
  return fail(ErrorCode::internal,
              file.string() + ": holds other frames than were driven; is somebody else using it?");
}

Result<sim::SimBodyConfig> fresh(const LeadTask& task, const std::string& robot, std::uint64_t day) {
  std::error_code problem;
  std::filesystem::remove(task.scratch, problem);
  if (problem) return fail(ErrorCode::unavailable, task.scratch.string() + ": " + problem.message());
  sim::SimBodyConfig config;
  config.site = task.site;
  config.robot = robot;
  config.seed = task.seed;
  config.day = day;
  config.truth_path = task.scratch.string();
  return config;
}

/// Leads a robot along the line; keeps a content every so many metres. None: stopped.
Result<std::optional<Run>> lead(const LeadTask& task, const sim::SimBodyConfig& config, double keep_every_m) {
  Result<std::unique_ptr<Body>> body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  Result<Floor> floor = Floor::make(FloorConfig{}, (*body)->rig().camera());
  if (!floor) return fail(floor.error());
  if (const Result<void> begun = (*body)->drive_by_hand(task.line); !begun) return fail(begun.error());
  Run run{std::move(*floor), {}, {}};
  Floor::Odometry odometry;
  Pose2 start_from_robot;
  double since_kept = keep_every_m;
  for (bool done = false; !done;) {
    if (task.asked_to_stop()) return std::optional<Run>();
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    const Step step = run.floor.observe(odometry, sample->of({}), sample->motion);
    const Pose2 moved = planar(step.previous_from_current);
    start_from_robot = start_from_robot * moved;
    since_kept += std::hypot(moved.x, moved.y);
    run.frames.push_back({{}, 0.0, start_from_robot, seconds(sample->time.time_since_epoch()), step.seen});
    if (!sample->views.empty() && since_kept >= keep_every_m) {
      auto content = run.floor.extract(odometry, *sample->of({}));
      run.kept.push_back({run.frames.size() - 1, content ? std::optional(std::move(*content)) : std::nullopt});
      since_kept = 0.0;
    }
    done = sample->hand_done;
  }
  if (const Result<void> true_ones = add_truth(task.scratch, run); !true_ones) return fail(true_ones.error());
  return std::optional(std::move(run));
}

/// Adds a second robot, which starts a hand's breadth beside the first, on other wheels. Returns its name.
std::string add_second(sim::Site& site) {
  sim::RobotStart second = site.robots.front();
  second.name = "beside";
  second.seed += 17;
  second.site_from_robot = second.site_from_robot * Pose2{0.0, 0.1, 0.05};
  site.robots.push_back(second);
  return second.name;
}

std::vector<Attempt> attempts_of(const Run& taught, const Run& repeated) {
  std::vector<Attempt> attempts;
  for (const KeptPlace& now : repeated.kept) {
    const Pose2& here = repeated.frames[now.frame].site_from_robot;
    const KeptPlace* nearest = nullptr;
    double best = kNearM;
    for (const KeptPlace& place : taught.kept) {
      const Pose2 apart = taught.frames[place.frame].site_from_robot.inverse() * here;
      const double away = std::hypot(apart.x, apart.y);
      if (!place.content || away > best || std::abs(apart.heading) > kNearRad) continue;
      best = away;
      nearest = &place;
    }
    if (nearest == nullptr) continue;
    Attempt attempt;
    attempt.place_from_robot = taught.frames[nearest->frame].site_from_robot.inverse() * here;
    if (now.content) {
      if (const auto related = repeated.floor.relate(*nearest->content, *now.content, std::nullopt)) {
        attempt.related = true;
        attempt.measured = planar(related->a_from_b);
      }
    }
    attempts.push_back(attempt);
  }
  return attempts;
}

}  // namespace

Result<std::optional<Score>> measure(const LeadTask& given) {
  LeadTask task = given;
  const std::string first = task.site.robots.front().name;
  const std::string second = add_second(task.site);
  std::vector<Run> runs;
  for (const auto& [robot, day, every] :
       {std::tuple{first, 0U, kPlaceEveryM}, std::tuple{second, 1U, kAttemptEveryM}}) {
    const Result<sim::SimBodyConfig> config = fresh(task, robot, day);
    if (!config) return fail(config.error());
    Result<std::optional<Run>> run = lead(task, *config, every);
    std::error_code ignored;  // a left-over file is removed at the next start
    std::filesystem::remove(task.scratch, ignored);
    if (!run) return fail(run.error());
    if (!*run) return std::optional<Score>();
    runs.push_back(std::move(**run));
  }
  return std::optional(score_of({runs[0].frames, runs[1].frames}, attempts_of(runs[0], runs[1])));
}

}  // namespace weft::evaluate
