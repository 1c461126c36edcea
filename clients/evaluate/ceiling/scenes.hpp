#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "agents/bodies/sim/site.hpp"
#include "agents/methods/ceiling/config.hpp"
#include "agents/perception/camera_model.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/scene.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Holds all that is driven below, and what says so in a folder of results.
struct Scenes {
  Scene straight;     ///< a line in the hall with beams, ducts and lamps
  Scene loop;         ///< round its rack
  Scene lamps;        ///< a line below a grid of lamps and nothing else
  Scene calibration;  ///< in the hall: what robots are led along whose mounts are calibrated
  std::string sha256;
};

/// Reads hall.toml, straight.line, loop.line, lamps.toml and lamps.line of a folder; of both lines at most so many
/// metres, of the loop all. Mounts are calibrated along 12 m of the loop, round its first bend. not_found, invalid:
/// names the file.
Result<Scenes> read_scenes(const std::filesystem::path& folder, double metres);

/// Says which robot drives in which scene, and when.
struct Driven {
  std::string robot = "r1";  ///< one of the site's
  std::uint64_t seed = 1;
  std::uint64_t day = 0;
  /// Stands in the file while it is driven: the truth, for the judge.
  std::filesystem::path scratch;
  std::function<bool()> asked_to_stop;
};

/// Returns the settings that every robot of a site is given: defaults, and the ceiling's height as somebody has
/// measured it who is right within 2 cm (1 sigma, drawn by the seed), and says so.
agents::CeilingConfig settings_in(const agents::sim::Site& site, std::uint64_t seed);

/// Holds what a robot is given before it drives.
struct Calibrated {
  agents::CeilingConfig settings;
  std::optional<agents::CameraModel> camera;  ///< as its calibration has it; none: as the site gives it
};

/// Returns a drive with the method `ceiling` of a robot that is given that.
floor::Drive drive_of(const agents::sim::Site& site, const Driven& driven, const Calibrated& given);

}  // namespace weft::evaluate::ceiling
