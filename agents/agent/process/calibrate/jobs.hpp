#pragma once
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <variant>

#include "agents/agent/process/options.hpp"
#include "agents/agent/process/program.hpp"
#include "agents/perception/calibration/board.hpp"
#include "agents/perception/calibration/camera_fit.hpp"
#include "core/result.hpp"

/// Holds `weft-agent calibrate ...`: programs of their own that find out what an agent is told with --calibration.
namespace weft::agents {

struct CameraJob {
  std::string folder;  ///< with images of the board
  Board board;
  LensModel lens = LensModel::radtan;
  std::string out;      ///< the camera file
  std::string picture;  ///< of the residuals
  bool json = false;
};

/// Describes a rough mount of a camera, measured by hand: good to 5 degrees and a few centimetres. Pitch is down from
/// level, yaw to the left as seen from above.
struct MountGuess {
  double height_m = 0.0, pitch_rad = 0.0, forward_m = 0.0, left_m = 0.0, yaw_rad = 0.0;
};

/// Names the methods that know a mount from a drive.
inline constexpr const char* kByFloor = "floor";
inline constexpr const char* kByCeiling = "ceiling";

/// Describes a drive to find the mount from: recorded, or of a simulated robot that is led along a line.
struct MountJob {
  std::string method = kByFloor;  ///< by which what the camera sees is followed
  double ceiling_m = 0.0;         ///< by the ceiling: above the floor, as guessed
  std::string recording;          ///< folder in EuRoC layout; empty: `site`, `robot`, `along`
  std::string site, robot, along;
  std::uint64_t seed = 1;
  std::string camera = "cam0";             ///< of the recording, and of a camera file that has several
  std::optional<std::string> calibration;  ///< camera file; none: as the body says
  std::optional<MountGuess> guess;         ///< none: the mount of the camera file or of the body
  std::optional<double> distance_m;
  double distance_sigma_m = 0.005;
  std::optional<double> wheels_sigma;  ///< share
  std::string out = "mount.yaml";
  bool json = false;
};

struct JobOutput {
  std::ostream& out;
  std::ostream& err;              ///< progress
  std::function<double()> now_s;  ///< steady
};

/// Reads "calibrate camera DIR ..." or "calibrate mount ...", without the program's name.
std::variant<CameraJob, MountJob, Leave> parse_calibrate(int argc, const char* const* argv);

/// Prints a row an image and what was found; writes camera file and picture. not_found: no such folder, no images;
/// refused: as fit_camera; exhausted: a file cannot be written.
Result<void> calibrate_camera(const CameraJob& job, const JobOutput& output);

/// Prints what was found of the mount and how well, writes a camera file with it. Errors as of the body and of
/// find_mount in agents/perception/mount_drive.hpp; exhausted: the file cannot be written.
Result<void> calibrate_mount(const Program& program, const MountJob& job, const JobOutput& output);

/// Draws each residual of the images, how large they are in each image, and how far the board got around.
Result<void> draw_residuals(const CameraFit& fit, const std::string& title, const std::string& file);

}  // namespace weft::agents
