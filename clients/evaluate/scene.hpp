#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Holds a site and a line in it.
struct Scene {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
};

/// Reads SITE.toml and LINE.line of a folder, and adds their texts to `texts`. not_found, invalid: names the file.
Result<Scene> read_scene(const std::filesystem::path& folder, const std::string& site, const std::string& line,
                         std::string& texts);

/// Returns the site with that robot, one of its own, put somewhere else.
agents::sim::Site with_start(agents::sim::Site site, const std::string& robot, const Pose2& site_from_robot);
/// Returns the start of that robot. It is one of the site's.
const agents::sim::RobotStart& start_of(const agents::sim::Site& site, const std::string& robot);
/// Rejects a site that lacks one of these robots (invalid, naming `folder`, the site and the robot).
Result<void> check_robots(const std::filesystem::path& folder, const agents::sim::Site& site,
                          const std::vector<std::string>& robots);

/// Returns the pose on a line's beginning, headed along it.
Pose2 beginning_of(const std::vector<agents::SitePoint>& line);

}  // namespace weft::evaluate
