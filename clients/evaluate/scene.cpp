#include "clients/evaluate/scene.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/line.hpp"

namespace weft::evaluate {

using agents::SitePoint;
using agents::sim::RobotStart;
using agents::sim::Site;

namespace {

auto find_start(auto& site, const std::string& robot) {
  return std::find_if(site.robots.begin(), site.robots.end(),
                      [&robot](const RobotStart& start) { return start.name == robot; });
}

}  // namespace

Result<Scene> read_scene(const std::filesystem::path& folder, const std::string& site, const std::string& line,
                         std::string& texts) {
  const std::filesystem::path site_file = folder / (site + ".toml");
  const Result<std::string> site_text = read_text(site_file, "site of the study; give its folder with --scenes");
  if (!site_text) return fail(site_text.error());
  Result<Site> parsed = agents::sim::parse_site(*site_text, site_file.string());
  if (!parsed) return fail(parsed.error());
  const std::filesystem::path line_file = folder / (line + ".line");
  const Result<std::string> line_text = read_text(line_file, "line of the study; give its folder with --scenes");
  if (!line_text) return fail(line_text.error());
  auto points = parse_line(*line_text, line_file.string());
  if (!points) return fail(points.error());
  texts += *site_text + "\n" + *line_text + "\n";
  return Scene{std::move(*parsed), std::move(*points)};
}

Site with_start(Site site, const std::string& robot, const Pose2& site_from_robot) {
  const auto found = find_start(site, robot);
  assert(found != site.robots.end());
  found->site_from_robot = site_from_robot;
  return site;
}

const RobotStart& start_of(const Site& site, const std::string& robot) {
  const auto found = find_start(site, robot);
  assert(found != site.robots.end());
  return *found;
}

Result<void> check_robots(const std::filesystem::path& folder, const Site& site,
                          const std::vector<std::string>& robots) {
  for (const std::string& robot : robots)
    if (find_start(site, robot) == site.robots.end())
      return fail(ErrorCode::invalid,
                  folder.string() + ": site " + site.name + " has no robot " + robot + ", which drives in it");
  return {};
}

Pose2 beginning_of(const std::vector<SitePoint>& line) {
  return {line[0].x, line[0].y, std::atan2(line[1].y - line[0].y, line[1].x - line[0].x)};
}

}  // namespace weft::evaluate
