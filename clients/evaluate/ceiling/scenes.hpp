#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "agents/methods/ceiling/config.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Holds a site and a line in it.
struct Scene {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
};

/// Holds all that is driven below, and what says so in a folder of results.
struct Scenes {
  Scene straight;  ///< a line in the hall with beams, ducts and lamps
  Scene loop;      ///< round its rack
  Scene lamps;     ///< a line below a grid of lamps and nothing else
  std::string sha256;
};

/// Reads hall.toml, straight.line, loop.line, lamps.toml and lamps.line of a folder; of both lines at most so many
/// metres, of the loop all. not_found, invalid: names the file.
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

/// Returns a drive with the method `ceiling` and these settings.
floor::Drive drive_of(const agents::sim::Site& site, const Driven& driven, const agents::CeilingConfig& settings);

/// Returns the site with that robot put somewhere else.
agents::sim::Site with_start(agents::sim::Site site, const std::string& robot, const Pose2& site_from_robot);
/// Returns the start of that robot. It is one of the site's.
const agents::sim::RobotStart& start_of(const agents::sim::Site& site, const std::string& robot);

}  // namespace weft::evaluate::ceiling
