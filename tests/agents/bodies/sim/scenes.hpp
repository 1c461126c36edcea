#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "agents/bodies/sim/base.hpp"
#include "agents/bodies/sim/site.hpp"

/// Reads sites and lines of deploy/sites, for tests of what stands there.
namespace weft::agents::sim {

inline Site scene_in(const std::string& folder, const std::string& name) {
  const std::ifstream file(folder + name);
  std::stringstream text;
  text << file.rdbuf();
  const Result<Site> site = parse_site(text.str(), name);
  EXPECT_TRUE(site) << site.error().message;
  return site ? *site : Site{};
}

inline std::vector<Eigen::Vector2d> line_in(const std::string& folder, const std::string& name) {
  std::vector<Eigen::Vector2d> line;
  std::ifstream rows(folder + name);
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row.substr(0, row.find('#')));
    Eigen::Vector2d p;
    if (numbers >> p.x() >> p.y()) line.push_back(p);
  }
  return line;
}

/// Returns points every 0.1 m along the line.
inline std::vector<Eigen::Vector2d> points_along(const std::vector<Eigen::Vector2d>& line) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d way = line[i] - line[i - 1];
    for (double s = 0.0; s < way.norm(); s += 0.1) points.emplace_back(line[i - 1] + way.normalized() * s);
  }
  return points;
}

/// Expects a line as long as that, on which a robot keeps half a metre from everything, and its middle so far from
/// the floor's bounds.
inline void expect_drivable(const Site& site, const std::vector<Eigen::Vector2d>& line, double length_m,
                            double within_m = 1.0) {
  ASSERT_GE(line.size(), 2U) << site.name;
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  EXPECT_NEAR(length, length_m, 0.5) << site.name;
  for (const Eigen::Vector2d& p : points_along(line)) {
    EXPECT_TRUE(p.x() > within_m && p.x() < site.floor.x_max - within_m && p.y() > within_m &&
                p.y() < site.floor.y_max - within_m)
        << site.name;
    for (const Box& box : site.boxes)
      EXPECT_GT(distance_to(box, p.x(), p.y()), site.base.radius_m + 0.5) << site.name << " and " << box.name;
  }
}

}  // namespace weft::agents::sim
