// What each disturbance of a simulated site costs the floor method: the table of docs/simulation.md.
// One robot is led along the beginning of a line and remembers places; another, on another day, is led along it
// again. Odometry is judged over pieces of a metre, relations between the two runs against the truth. Usage:
// sim-disturbance-costs SITE.toml LINE [METRES [SEEDS]]
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/floor/floor.hpp"

namespace {

using namespace weft;
using namespace weft::agents;
using sim::Disturbances;
using sim::Site;

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<SitePoint> first_metres_of(const std::string& path, double metres) {
  std::vector<SitePoint> line;
  std::istringstream rows(text_of(path));
  double along = 0.0;
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row.substr(0, row.find('#')));
    SitePoint p;
    if (!(numbers >> p.x >> p.y)) {
      continue;
    }
    if (!line.empty()) {
      const double step = std::hypot(p.x - line.back().x, p.y - line.back().y);
      if (along + step > metres) {
        const double share = (metres - along) / step;
        line.push_back(
            {line.back().x + share * (p.x - line.back().x), line.back().y + share * (p.y - line.back().y)});
        break;
      }
      along += step;
    }
    line.push_back(p);
  }
  return line;
}

struct Place {
  Pose2 site_from_robot;
  FloorContent content;
};
struct Run {
  std::vector<Pose2> truth;     ///< of each frame
  std::vector<Pose2> odometry;  ///< start_from_robot, as measured
  std::vector<Place> places;
  int blind = 0;
  std::optional<Floor> floor;  ///< as its agent would have it
};

std::vector<Pose2> truth_in(const std::string& path) {
  std::vector<Pose2> poses;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const auto row = nlohmann::json::parse(line);
    poses.push_back({row["x"], row["y"], row["heading"]});
  }
  return poses;
}

template <class T>
T value_of(Result<T> result) {
  if (!result) {
    std::cerr << result.error().message << '\n';
    std::exit(1);
  }
  return std::move(*result);
}

Run led(const Site& site, const std::string& robot, std::uint64_t seed, std::uint64_t day,
        const std::vector<SitePoint>& line) {
  constexpr double kPlaceEveryM = 0.25;
  const std::string truth =
      (std::filesystem::temp_directory_path() / ("weft-costs-" + std::to_string(getpid()))).string();
  std::filesystem::remove(truth);
  sim::SimBodyConfig config;
  config.site = site;
  config.robot = robot;
  config.seed = seed;
  config.day = day;
  config.truth_path = truth;
  auto body = value_of(sim::make_sim_body(config));
  const Floor floor = value_of(Floor::make(FloorConfig{}, body->cameras()[0]));
  if (auto begun = body->drive_by_hand(line); !begun) {
    std::cerr << begun.error().message << '\n';
    std::exit(1);
  }
  Run run;
  Floor::Odometry odometry;
  Pose2 start_from_robot;
  std::vector<std::pair<std::size_t, FloorContent>> kept;
  double since_place = 1e9;
  for (bool done = false; !done;) {
    const Sample sample = value_of(body->step({}));
    const Step step = floor.observe(odometry, sample.view ? &*sample.view : nullptr, sample.motion);
    const Pose2 moved = planar(step.previous_from_current);
    start_from_robot = start_from_robot * moved;
    run.blind += step.seen ? 0 : 1;
    since_place += std::hypot(moved.x, moved.y);
    run.odometry.push_back(start_from_robot);
    if (sample.view && since_place > kPlaceEveryM) {
      if (auto content = floor.extract(odometry, *sample.view)) {
        kept.emplace_back(run.odometry.size() - 1, std::move(*content));
        since_place = 0.0;
      }
    }
    done = sample.hand_done;
  }
  run.truth = truth_in(truth);
  for (auto& [frame, content] : kept) {
    run.places.push_back({run.truth[frame], std::move(content)});
  }
  std::filesystem::remove(truth);
  run.floor = floor;
  return run;
}

struct Costs {
  std::vector<double> drift_m, drift_rad;  ///< over each metre driven
  std::vector<double> off_m, off_rad;      ///< of relations between the runs
  int related = 0, tried = 0, blind = 0, frames = 0;
};

void add_odometry(const Run& run, Costs& costs) {
  std::size_t from = 0;
  double along = 0.0;
  for (std::size_t i = 1; i < run.truth.size(); ++i) {
    along += (run.truth[i].translation() - run.truth[i - 1].translation()).norm();
    if (along >= 1.0) {
      const Pose2 moved = run.truth[from].inverse() * run.truth[i];
      const Pose2 measured = run.odometry[from].inverse() * run.odometry[i];
      const Pose2 off = moved.inverse() * measured;
      costs.drift_m.push_back(std::hypot(off.x, off.y));
      costs.drift_rad.push_back(std::abs(off.heading));
      from = i;
      along = 0.0;
    }
  }
  costs.blind += run.blind;
  costs.frames += static_cast<int>(run.truth.size());
}

void add_relations(const Run& taught, const Run& repeated, const Floor& floor, Costs& costs) {
  for (const Place& now : repeated.places) {
    const auto nearest =
        std::min_element(taught.places.begin(), taught.places.end(), [&](const Place& a, const Place& b) {
          return (a.site_from_robot.translation() - now.site_from_robot.translation()).norm() <
                 (b.site_from_robot.translation() - now.site_from_robot.translation()).norm();
        });
    const Pose2 truth = nearest->site_from_robot.inverse() * now.site_from_robot;
    if (std::hypot(truth.x, truth.y) > 0.3 || std::abs(truth.heading) > 0.5) {
      continue;
    }
    ++costs.tried;
    if (const auto related = floor.relate(nearest->content, now.content, std::nullopt)) {
      const Pose2 off = truth.inverse() * planar(related->a_from_b);
      ++costs.related;
      costs.off_m.push_back(std::hypot(off.x, off.y));
      costs.off_rad.push_back(std::abs(off.heading));
    }
  }
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) {
    return NAN;
  }
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void measure(const std::string& name, Site site, const Disturbances& disturbances, const std::vector<SitePoint>& line,
             int seeds) {
  site.disturbances = disturbances;
  // The second robot starts where the first did, a hand's breadth beside it, on other wheels.
  sim::RobotStart beside = site.robots[0];
  beside.name = "beside";
  beside.seed += 17;
  beside.site_from_robot = beside.site_from_robot * Pose2{0.0, 0.1, 0.05};
  site.robots.push_back(beside);
  Costs costs;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto s = static_cast<std::uint64_t>(seed);
    const Run taught = led(site, site.robots[0].name, s, 0, line);
    const Run repeated = led(site, beside.name, s, 1, line);
    add_odometry(taught, costs);
    add_odometry(repeated, costs);
    add_relations(taught, repeated, *repeated.floor, costs);
  }
  constexpr double kDegree = 180.0 / M_PI;
  std::printf("| %s | %.1f | %.2f | %.1f | %.1f | %.2f | %d/%d | %.2f |\n", name.c_str(),
              1e3 * quantile(costs.drift_m, 0.5), kDegree * quantile(costs.drift_rad, 0.5),
              1e3 * quantile(costs.off_m, 0.5), 1e3 * quantile(costs.off_m, 0.95),
              kDegree * quantile(costs.off_rad, 0.5), costs.related, costs.tried,
              100.0 * costs.blind / std::max(1, costs.frames));
  std::fflush(stdout);
}

Disturbances none() {
  Disturbances d;
  for (double* value :
       {&d.focal_error, &d.mount_error_m, &d.mount_error_rad, &d.vibration_rad, &d.vibration_m, &d.exposure_s,
        &d.noise_grey, &d.vignetting, &d.exposure_drift, &d.dropped_frames, &d.time_jitter_s, &d.wheel_scale_error,
        &d.wheel_asymmetry, &d.slip, &d.light_change, &d.shadow}) {
    *value = 0.0;
  }
  return d;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: sim-disturbance-costs SITE.toml LINE [METRES [SEEDS]]\n";
    return 2;
  }
  const Site site = value_of(sim::parse_site(text_of(argv[1]), argv[1]));
  const auto line = first_metres_of(argv[2], argc > 3 ? std::atof(argv[3]) : 6.0);
  const int seeds = argc > 4 ? std::atoi(argv[4]) : 1;
  const Disturbances all = site.disturbances;
  using Switch = std::function<void(Disturbances&)>;
  const std::vector<std::pair<std::string, Switch>> switches = {
      {"focal length", [&](Disturbances& d) { d.focal_error = all.focal_error; }},
      {"mount position", [&](Disturbances& d) { d.mount_error_m = all.mount_error_m; }},
      {"mount angle", [&](Disturbances& d) { d.mount_error_rad = all.mount_error_rad; }},
      {"vibration, angle", [&](Disturbances& d) { d.vibration_rad = all.vibration_rad; }},
      {"vibration, height", [&](Disturbances& d) { d.vibration_m = all.vibration_m; }},
      {"blur", [&](Disturbances& d) { d.exposure_s = all.exposure_s; }},
      {"noise", [&](Disturbances& d) { d.noise_grey = all.noise_grey; }},
      {"vignetting", [&](Disturbances& d) { d.vignetting = all.vignetting; }},
      {"exposure drift", [&](Disturbances& d) { d.exposure_drift = all.exposure_drift; }},
      {"dropped frames", [&](Disturbances& d) { d.dropped_frames = all.dropped_frames; }},
      {"time jitter", [&](Disturbances& d) { d.time_jitter_s = all.time_jitter_s; }},
      {"wheels and slip",
       [&](Disturbances& d) {
         d.wheel_scale_error = all.wheel_scale_error;
         d.wheel_asymmetry = all.wheel_asymmetry;
         d.slip = all.slip;
       }},
      {"light", [&](Disturbances& d) { d.light_change = all.light_change; }},
      {"own shadow", [&](Disturbances& d) { d.shadow = all.shadow; }},
  };
  std::printf("| alone | odometry mm/m | deg/m | relation mm | 95 %% mm | deg | related | blind %% |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  measure("none", site, none(), line, seeds);
  for (const auto& [name, turn_on] : switches) {
    Disturbances d = none();
    turn_on(d);
    measure(name, site, d, line, seeds);
  }
  measure("all", site, all, line, seeds);
  return 0;
}
