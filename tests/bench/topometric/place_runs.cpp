#include "tests/bench/topometric/place_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/scene.hpp"

namespace weft::bench {
namespace {

using namespace agents;
using Line = std::vector<SitePoint>;

constexpr double kApartM = 0.5;     // as the method's defaults have it
constexpr double kApartRad = 0.35;  // the same
constexpr double kQuickM = 6.0;
constexpr double kFps = 4.0;  // enough for a window of frames 0.12 m apart

/// Describes a line that a robot is led along.
struct Way {
  const char* site = "";
  const char* line = "";
  const char* robot = "";
  bool is_backward = false;
};
constexpr Way kKnown[] = {{"level11", "level11", "r1"},  {"level11", "level11", "r1", true},
                          {"hall", "hall", "r1"},        {"hall", "hall", "r1", true},
                          {"aisles", "aisles-r1", "r1"}, {"aisles", "aisles-r2", "r1"},
                          {"fleet", "fleet-r1", "r1"},   {"fleet", "fleet-r2", "r1"}};
constexpr Way kSeen[] = {
    {"level11", "level11", "r2"}, {"hall", "hall", "r1"}, {"aisles", "aisles-r1", "r2"}, {"fleet", "fleet-r2", "r2"}};

struct When {
  std::uint64_t seed = 1;
  std::uint64_t day = 0;
};

/// Leads a robot along a line, and takes what a place stores wherever one is due.
class Led {
 public:
  Led(std::unique_ptr<sim::SimulatedBody> body, Topometric method)
      : body_(std::move(body)), method_(std::move(method)) {}

  Result<void> along(const Line& line, const std::string& site, std::vector<RunPlace>& places) {
    if (const Result<void> begun = body_->drive_by_hand(line); !begun) return begun;
    Topometric::Odometry odometry;
    std::optional<Pose2> last;
    for (bool is_done = false; !is_done;) {
      const Result<Sample> sample = body_->step({});
      if (!sample) return fail(sample.error());
      is_done = sample->hand_done;
      const View* const view = sample->of("stereo");
      static_cast<void>(method_.observe(odometry, view, sample->motion));
      const Pose2 at = body_->site_from_robot();
      if (view == nullptr || (last && !is_due(last->inverse() * at))) continue;
      OrRefusal<TopometricContent> content = method_.extract(odometry, *view);
      if (!content) continue;
      last = at;
      content->scan.reset();
      Bytes bytes = method_.encode(*content);
      places.push_back({site, at, std::move(bytes), std::move(*content)});
    }
    return {};
  }

 private:
  static bool is_due(const Pose2& moved) {
    return moved.translation().norm() >= kApartM || std::abs(moved.heading) >= kApartRad;
  }

  std::unique_ptr<sim::SimulatedBody> body_;
  Topometric method_;
};

Result<void> drive(const std::filesystem::path& sites, const Way& way, const When& when, bool is_quick,
                   std::vector<RunPlace>& places) {
  std::string texts;
  Result<evaluate::Scene> scene = evaluate::read_scene(sites, way.site, way.line, texts);
  if (!scene) return fail(scene.error());
  Line line = scene->line;
  if (way.is_backward) std::reverse(line.begin(), line.end());
  if (is_quick) line = evaluate::floor::stretch(line, 0.0, kQuickM);
  sim::SimBodyConfig config;
  config.site = evaluate::with_start(scene->site, way.robot, evaluate::beginning_of(line));
  config.site.stereo_camera.fps = kFps;
  config.robot = way.robot;
  config.seed = when.seed;
  config.day = when.day;
  auto body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  Result<Topometric> method = Topometric::make({}, (*body)->rig());
  if (!method) return fail(method.error());
  if (const auto led = Led(std::move(*body), std::move(*method)).along(line, way.site, places); !led) return led;
  std::printf("%s%s, seed %llu: %zu places so far\n", way.line, way.is_backward ? ", backward" : "",
              static_cast<unsigned long long>(when.seed), places.size());
  std::fflush(stdout);
  return {};
}

}  // namespace

Result<PlaceRuns> drive_places(const std::filesystem::path& sites, bool is_quick) {
  PlaceRuns runs;
  for (const Way& way : kKnown)
    if (const auto driven = drive(sites, way, {1, 0}, is_quick, runs.known); !driven) return fail(driven.error());
  for (const Way& way : kSeen)
    if (const auto driven = drive(sites, way, {2, 1}, is_quick, runs.seen); !driven) return fail(driven.error());
  return runs;
}

}  // namespace weft::bench
