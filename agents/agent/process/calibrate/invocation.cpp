#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "core/text.hpp"

namespace weft::agents {
namespace {

constexpr int kBadWords = 2;

struct Grid {
  int columns = 0;
  int rows = 0;
};
/// Reads a grid such as "9x6".
Grid grid_from(const std::string& flag, const std::string& text) {
  Grid grid;
  const std::size_t x = text.find('x');
  const auto whole = [&](std::size_t from, std::size_t to, int& into) {
    const auto [end, problem] = std::from_chars(text.data() + from, text.data() + to, into);
    return problem == std::errc() && end == text.data() + to;
  };
  if (x == std::string::npos || !whole(0, x, grid.columns) || !whole(x + 1, text.size(), grid.rows))
    throw CLI::ValidationError(flag + ": '" + text + "' is not COLUMNSxROWS, as 9x6");
  return grid;
}

/// Holds the words of the command line, before they are a job.
struct Words {
  std::string chessboard, tags, model = "radtan";
  std::optional<double> square_mm, tag_mm, gap_mm;
};

Board board_from(const Words& words) {
  constexpr double kMillimetre = 0.001;
  const auto metres = [](const char* flag, const std::optional<double>& given) {
    if (!given.has_value()) throw CLI::RequiredError(flag);
    return kMillimetre * *given;
  };
  if (words.chessboard.empty() == words.tags.empty())
    throw CLI::ValidationError(
        "say which board it is: --chessboard 9x6 --square-mm 25, or --apriltags 6x6 --tag-mm 88 "
        "--gap-mm 26.4");
  if (!words.chessboard.empty()) {
    const Grid grid = grid_from("--chessboard", words.chessboard);
    return ChessBoard{grid.columns, grid.rows, metres("--square-mm", words.square_mm)};
  }
  const Grid grid = grid_from("--apriltags", words.tags);
  return TagBoard{grid.columns, grid.rows, metres("--tag-mm", words.tag_mm), metres("--gap-mm", words.gap_mm)};
}

void camera_options(CLI::App& sub, CameraJob& job, Words& words) {
  sub.add_option("DIR", job.folder, "Folder with the images: .png .jpg .jpeg .pgm")->required()->type_name("");
  sub.add_option("--chessboard", words.chessboard, "Its inner corners, where four squares meet, as 9x6")
      ->type_name("CxR");
  sub.add_option("--square-mm", words.square_mm, "The side of a square, 1 to 2000, measured on the print")
      ->type_name("MM");
  sub.add_option("--apriltags", words.tags, "A grid of AprilTags 36h11, as Kalibr's AprilGrid 6x6")->type_name("CxR");
  sub.add_option("--tag-mm", words.tag_mm, "The side of a tag's black square, 1 to 2000")->type_name("MM");
  sub.add_option("--gap-mm", words.gap_mm, "Between two tags, 1 to 2000 (Kalibr: tagSpacing x tagSize)")
      ->type_name("MM");
  sub.add_option("--model", words.model, "radtan | equidistant (wide lenses, from about 110 degrees) [radtan]")
      ->check(CLI::IsMember({"radtan", "equidistant"}).description(""))
      ->type_name("M");
  sub.add_option("--out", job.out, "The camera file to write [camera.yaml]")->type_name("FILE");
  sub.add_option("--picture", job.picture, "The picture of residuals, *.png [beside the camera file]")
      ->type_name("FILE");
  sub.add_flag("--json", job.json, "Print one JSON document");
}

/// Holds the mount's flags, in the units of the command line.
struct MountWords {
  std::optional<double> height_m, pitch_deg, yaw_deg, forward_m, left_m, distance_m, wheels_percent, ceiling_m;
  double distance_sigma_mm = 5.0;
};

void mount_options(CLI::App& sub, MountJob& job, MountWords& words) {
  const auto number = [&](const char* flag, auto& into, double low, double high, const char* unit, const char* help) {
    sub.add_option(flag, into, help)->check(CLI::Range(low, high).description(""))->type_name(unit);
  };
  CLI::Option* const folder =
      sub.add_option("DIR", job.recording, "The drive: a recording in EuRoC layout")->type_name("");
  sub.add_option("--camera", job.camera, "Which of its cameras [cam0]")->type_name("NAME");
  sub.add_option("--calibration", job.calibration,
                 "Camera file of `weft calibrate camera` [the recording's sensor.yaml]")
      ->type_name("FILE");
  sub.add_option("--method", job.method, "What it looks at: floor | ceiling [floor]")
      ->check(CLI::IsMember({kByFloor, kByCeiling}).description(""))
      ->type_name("M");
  number("--ceiling-m", words.ceiling_m, 1.0, 40.0, "M",
         "With --method ceiling: the ceiling above the floor, to a tenth of it; distance or wheels correct it");
  number("--distance-m", words.distance_m, 0.5, 1000.0, "M",
         "Straight from where the robot stood first to where it stood last, measured: shows the height");
  number("--distance-sigma-mm", words.distance_sigma_mm, 0.1, 1000.0, "MM", "How well that was measured [5]");
  number("--wheels-percent", words.wheels_percent, 0.01, 20.0, "P",
         "How well the wheels' odometry is known, one sigma: shows the height where no distance is given");
  number("--height-m", words.height_m, 0.05, 5.0, "M",
         "A first guess: the camera above the floor [the file's mount]");
  number("--pitch-deg", words.pitch_deg, -90.0, 90.0, "DEG",
         "It looks down by so much from level: 10 to 90, with --method ceiling -90 (straight up) to -45");
  number("--yaw-deg", words.yaw_deg, -360.0, 360.0, "DEG",
         "Turned to the left by so much, seen from above; 0: the image's left is the robot's, or straight up, its "
         "bottom is ahead [0]");
  number("--forward-m", words.forward_m, -3.0, 3.0, "M", "Ahead of the middle between the wheels [0]");
  number("--left-m", words.left_m, -3.0, 3.0, "M", "To the left of it [0]");
  CLI::Option* const site = sub.add_option("--site", job.site, "Instead of DIR: a simulated robot of this site")
                                ->type_name("FILE")
                                ->excludes(folder);
  sub.add_option("--name", job.robot, "Which of the site's robots")->type_name("NAME")->needs(site);
  sub.add_option("--along", job.along, "Points 'x y' that it is led along")->type_name("FILE")->needs(site);
  sub.add_option("--seed", job.seed, "Of everything random in the simulation [1]")->type_name("N")->needs(site);
  sub.add_option("--out", job.out, "The camera file to write [mount.yaml]")->type_name("FILE");
  sub.add_flag("--json", job.json, "Print one JSON document");
}

/// Throws where the words on the plane do not go together.
void check_plane(const MountJob& job, const MountWords& words) {
  const bool is_ceiling = job.method == kByCeiling;
  if (is_ceiling && !words.ceiling_m.has_value())
    throw CLI::ValidationError("--method ceiling: how high is it? --ceiling-m, to a tenth of it");
  if (!is_ceiling && words.ceiling_m.has_value())
    throw CLI::ValidationError("--ceiling-m goes with --method ceiling");
  if (!words.pitch_deg.has_value()) return;
  constexpr double kLevelDown = 10.0;
  constexpr double kLevelUp = -45.0;
  if (is_ceiling && *words.pitch_deg > kLevelUp)
    throw CLI::ValidationError("--pitch-deg: with --method ceiling it is -90 (straight up) to -45");
  if (!is_ceiling && *words.pitch_deg < kLevelDown)
    throw CLI::ValidationError("--pitch-deg: with --method floor it is 10 to 90");
}

/// Returns the mount as it was measured by hand; none: it was not. Throws where a part of it is missing.
std::optional<MountGuess> guess_in(const MountWords& words) {
  if (words.height_m.has_value() != words.pitch_deg.has_value())
    throw CLI::ValidationError("--height-m and --pitch-deg go together");
  const bool has_more = words.forward_m.has_value() || words.left_m.has_value() || words.yaw_deg.has_value();
  if (!words.height_m.has_value() && has_more)
    throw CLI::ValidationError("--forward-m, --left-m and --yaw-deg go with --height-m and --pitch-deg");
  if (!words.height_m.has_value()) return std::nullopt;
  constexpr double kDegree = 3.14159265358979 / 180.0;
  return MountGuess{*words.height_m, kDegree * *words.pitch_deg, words.forward_m.value_or(0.0),
                    words.left_m.value_or(0.0), kDegree * words.yaw_deg.value_or(0.0)};
}

void finish(MountJob& job, const MountWords& words) {
  if (job.recording.empty() && job.site.empty())
    throw CLI::ValidationError("say which drive: a recording's folder, or --site, --name and --along");
  if (!job.site.empty() && (job.robot.empty() || job.along.empty()))
    throw CLI::RequiredError("--site: --name and --along");
  check_plane(job, words);
  job.ceiling_m = words.ceiling_m.value_or(0.0);
  job.guess = guess_in(words);
  job.distance_m = words.distance_m;
  job.distance_sigma_m = 1e-3 * words.distance_sigma_mm;
  if (words.wheels_percent.has_value()) job.wheels_sigma = 0.01 * *words.wheels_percent;
}

Leave mistake(const std::string& what) {
  return {.exit_code = kBadWords, .text = "weft calibrate: " + one_line(what) + "; see weft calibrate --help\n"};
}

}  // namespace

std::variant<CameraJob, MountJob, Leave> parse_calibrate(int argc, const char* const* argv) {
  CLI::App app("Find out what an agent has to know of its camera.", "weft calibrate");
  app.require_subcommand(1);
  CameraJob job;
  job.out = "camera.yaml";
  Words words;
  CLI::App* const camera = app.add_subcommand(
      "camera",
      "Lens and focal length from at least 6 images of a flat board, better 15 to 30: near, in all parts of the "
      "image, "
      "tilted by 30 degrees to all sides, in the focus that the robot drives with.\n"
      "Prints the reprojection error of each image; writes a camera file (for `weft-agent --calibration` and `weft "
      "calibrate mount`) and a picture of the residuals.");
  camera_options(*camera, job, words);
  CLI::App* const mount = app.add_subcommand(
      "mount",
      "How the camera sits on its robot, from a drive of 5 m or more with some bends: pitch and roll from what it "
      "sees "
      "of the floor, or with --method ceiling of the ceiling, yaw and place ahead from the base's not sliding "
      "sideways, height from a measured distance or the wheels.\n"
      "Calibrate the camera first: a focal length that is 0.3 % wrong makes the pitch 0.1 degrees wrong. Writes a "
      "camera "
      "file with the mount (for `weft-agent --calibration`).");
  MountJob mount_job;
  MountWords mount_words;
  mount_options(*mount, mount_job, mount_words);
  try {
    app.parse(argc, argv);
    if (mount->parsed()) {
      finish(mount_job, mount_words);
      return mount_job;
    }
    job.board = board_from(words);
  } catch (const CLI::CallForHelp&) {
    return Leave{.exit_code = 0, .text = app.help()};
  } catch (const CLI::ParseError& problem) {
    return mistake(problem.what());
  }
  if (const Result<void> good = check(job.board); !good) return mistake(good.error().message);
  job.lens = words.model == "equidistant" ? LensModel::equidistant : LensModel::radtan;
  if (job.picture.empty()) job.picture = std::filesystem::path(job.out).replace_extension(".png").string();
  if (!job.picture.ends_with(".png")) return mistake("--picture: " + job.picture + " does not end in .png");
  return job;
}

}  // namespace weft::agents
