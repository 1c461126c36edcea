#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "agents/agent/process/equip.hpp"
#include "agents/agent/process/recorded_body.hpp"
#include "agents/agent/process/words.hpp"
#include "agents/methods/advance.hpp"
#include "agents/methods/ceiling/mount_drive.hpp"
#include "agents/methods/floor/mount_drive.hpp"
#include "core/polyline.hpp"

namespace weft::agents {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Result<std::vector<SitePoint>> read_line(const std::string& file) {
  std::ifstream in(file);
  if (!in) return fail(ErrorCode::not_found, file + ": no such file; --along wants points 'x y' a row");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const Result<std::vector<PolylinePoint>> read = parse_polyline_points(text, file);
  if (!read) return fail(read.error());
  std::vector<SitePoint> points;
  for (const auto& [x, y] : *read) points.push_back({x, y});
  return points;
}

Options options_of(const MountJob& job) {
  Options options;
  options.name = job.robot;
  options.methods = {job.method};
  options.body = job.site.empty() ? kRecordedBody.name : kSimulated;
  options.site = job.site;
  options.seed = job.seed;
  options.recording = job.recording;
  options.camera = job.camera;
  options.calibration = job.calibration;
  if (job.guess.has_value())
    options.mount = downward_mount(job.guess->forward_m, job.guess->left_m, job.guess->height_m, job.guess->pitch_rad,
                                   0.0, job.guess->yaw_rad);
  return options;
}

/// Goes once through the drive, whatever it is of, as one sensor sees it.
Result<void> play(const Program& program, const MountJob& job, const std::vector<SitePoint>& line,
                  const std::string& sensor, const Warn& warn,
                  const std::function<void(const View*, const Motion&)>& take) {
  Result<std::unique_ptr<Body>> body = make_body(program, options_of(job), warn);
  if (!body) return fail(body.error());
  if (!line.empty()) {
    if (const Result<void> led = (*body)->drive_by_hand(line); !led) return led;
  }
  Motion since;
  for (;;) {
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return {};  // the recording is over; images that could not be read were warned of, and are blind
    since = joined(since, sample->motion);
    const View* const view = sample->of(sensor);
    if (view != nullptr || sample->views.empty()) take(view, std::exchange(since, Motion{}));
    if (sample->hand_done) return {};
  }
}

nlohmann::ordered_json document_of(const MountDrive& found, const MountJob& job) {
  const auto maybe = [](const std::optional<double>& value) {
    return value.has_value() ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  static constexpr std::array kFrom = {"nothing", "distance", "wheels"};
  nlohmann::ordered_json document = {{"method", job.method},
                                     {"pitch_change_rad", found.pitch_rad},
                                     {"roll_change_rad", found.roll_rad},
                                     {"tilt_sigma_rad", maybe(found.camera.sigma.tilt_rad)},
                                     {"yaw_seen", found.yaw_seen},
                                     {"yaw_change_rad", found.lever.yaw_rad},
                                     {"yaw_sigma_rad", maybe(found.camera.sigma.yaw_rad)},
                                     {"forward_seen", found.forward_seen},
                                     {"forward_change_m", found.lever.forward_m},
                                     {"height_from", kFrom.at(static_cast<std::size_t>(found.height_from))},
                                     {"height_m", found.camera.robot_from_camera.translation.z()},
                                     {"height_change_share", found.height_share},
                                     {"scale_sigma_share", maybe(found.scale_sigma)},
                                     {"images", found.samples},
                                     {"blind", found.blind},
                                     {"driven_m", found.path_m},
                                     {"camera_file", job.out}};
  if (job.method != kByCeiling) return document;
  document["ceiling_m"] = found.plane_m;
  document["ceiling_sigma_m"] = maybe(found.plane_sigma_m());
  return document;
}

/// Says how high the camera is above the floor, or the ceiling is, and from where that is known.
std::string height_words(const MountDrive& found, const MountJob& job) {
  const bool is_ceiling = job.method == kByCeiling;
  const double height_m = is_ceiling ? found.plane_m : found.camera.robot_from_camera.translation.z();
  const char* const what = is_ceiling ? "ceiling" : "height ";
  if (!found.scale_sigma.has_value())
    return text("%s %8.4f m  as given: not observable from the drive alone; give --distance-m, or --wheels-percent",
                what, height_m);
  return text("%s %8.4f m  %+.2f %%, distances to %.2f %% (one sigma), by %s", what, height_m,
              100.0 * found.height_share, 100.0 * *found.scale_sigma,
              found.height_from == HeightFrom::distance ? "the measured distance" : "the wheels");
}

void print(const MountDrive& found, const MountJob& job, std::ostream& out) {
  const double tilt_sigma = *found.camera.sigma.tilt_rad / kDegree;
  out << "        found less given\n";
  out << text("pitch   %+8.3f degrees, one sigma %.3f\n", found.pitch_rad / kDegree, tilt_sigma);
  out << text("roll    %+8.3f degrees, one sigma %.3f\n", found.roll_rad / kDegree, tilt_sigma);
  if (found.yaw_seen) {
    out << text("yaw     %+8.3f degrees, one sigma %.3f\n", found.lever.yaw_rad / kDegree,
                found.lever.yaw_sigma_rad / kDegree);
  } else {
    out << "yaw     as given: not observable, the drive has too little that is straight\n";
  }
  if (found.forward_seen) {
    out << text("forward %+8.1f mm, one sigma %.1f\n", 1e3 * found.lever.forward_m,
                1e3 * found.lever.forward_sigma_m);
  } else {
    out << "forward as given: not observable, the drive has too few bends\n";
  }
  out << height_words(found, job) << '\n';
  out << text("%zu images, %zu of them blind, %.2f m driven\n", found.samples, found.blind, found.path_m);
}

}  // namespace

Result<void> calibrate_mount(const Program& program, const MountJob& job, const JobOutput& output) {
  std::vector<SitePoint> line;
  if (!job.site.empty()) {
    Result<std::vector<SitePoint>> read = read_line(job.along);
    if (!read) return fail(read.error());
    line = std::move(*read);
  }
  bool warned = false;
  const Warn warn = [&](const std::string& words) {
    if (!warned) output.err << words << '\n';
  };
  const Result<std::unique_ptr<Body>> body = make_body(program, options_of(job), warn);
  if (!body) return fail(body.error());
  const Result<std::vector<Equipped>> equipped = equip(options_of(job), **body, warn);
  if (!equipped) return fail(equipped.error());
  const CameraModel& given = equipped->front().rig.camera();

  MountDriveConfig config;
  config.prior.focal_share = given.sigma.focal_share.value_or(config.prior.focal_share);
  config.plane_m = job.ceiling_m;
  config.distance_m = job.distance_m;
  config.distance_sigma_m = job.distance_sigma_m;
  config.wheels_sigma = job.wheels_sigma;
  constexpr double kBetweenLines = 2.0;
  double said_s = output.now_s();
  int pass = 0;
  const PlayDrive again = [&](const std::function<void(const View*, const Motion&)>& take) -> Result<void> {
    ++pass;
    std::size_t images = 0;
    Result<void> played = play(program, job, line, equipped->front().rig.sensors.front().id, warn,
                               [&](const View* view, const Motion& motion) {
                                 take(view, motion);
                                 ++images;
                                 if (output.now_s() - said_s < kBetweenLines) return;
                                 said_s = output.now_s();
                                 output.err << "time " << pass << " of 3 through the drive, " << images << " images"
                                            << std::endl;
                               });
    warned = true;
    return played;
  };
  const Result<MountDrive> found = job.method == kByCeiling ? calibrate_ceiling_mount(given, again, config)
                                                            : calibrate_floor_mount(given, again, config);
  if (!found) return fail(found.error());

  const CameraCalibration camera = calibration_from(found->camera);
  std::ofstream file(job.out, std::ios::trunc);
  file << camera_file_text(
      camera, {text("mount by weft calibrate mount: %.2f m driven, %zu images", found->path_m, found->samples)});
  file.close();
  if (!file) return fail(ErrorCode::exhausted, job.out + ": cannot be written; is the folder there?");
  if (job.json) {
    output.out << document_of(*found, job).dump(2) << '\n';
    return {};
  }
  print(*found, job, output.out);
  output.out << job.out << " holds camera and mount: weft-agent --calibration " << job.out << '\n';
  if (const std::optional<double> sigma_m = found->plane_sigma_m(); job.method == kByCeiling && sigma_m)
    output.out << text(
        "the ceiling goes into the agent's --config: [ceiling] height_m = %.3f, height_sigma_m = %.3f\n",
        found->plane_m, *sigma_m);
  return {};
}

}  // namespace weft::agents
