#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "clients/evaluate/bearing/course.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// Holds a site and the closed line that is driven in it.
struct Scene {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
  std::string sha256;  ///< of both files
};
/// Reads a site and a line. not_found, invalid: names file and line.
Result<Scene> read_scene(const std::filesystem::path& folder, const std::string& site, const std::string& line);

/// Describes a drive by the site's first robot, so many days after teaching.
Drive drive_of(const Scene& scene, std::uint64_t seed, std::uint64_t day, const std::function<bool()>& asked_to_stop);

/// Leaves starlight only, and a lamp on the robot.
void dark(agents::sim::Site& site);
/// Leaves that and half of the lamps, which ones by the seed.
void half_of_the_lamps(agents::sim::Site& site);

/// Describes one of the experiments of Krajnik et al. 2018, or one that goes beyond.
struct Trial {
  std::string name;
  std::string about;       ///< for tables and pictures
  std::string site;        ///< SITE.toml
  std::string line;        ///< LINE.line
  Pose2 start_from_robot;  ///< where it is put down, against where it was taught first
  std::size_t loops = 1;
  Parts parts = Parts::all;
  std::function<void(agents::sim::Site&)> as_taught;    ///< what the site is like then
  std::function<void(agents::sim::Site&)> as_repeated;  ///< and a day later
};
/// Returns all trials in the order of the table.
const std::vector<Trial>& trials();

}  // namespace weft::evaluate::bearing
