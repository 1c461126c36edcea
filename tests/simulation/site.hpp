#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/bodies/body.hpp"
#include "core/random.hpp"
#include "tests/simulation/course.hpp"
#include "tests/simulation/marked_floor.hpp"

namespace weft::simulation {

/// Describes where a fleet lives: a course with its sidings on a floor of marks.
class Site {
 public:
  Site(std::unique_ptr<const Course> course, MarkedFloor floor)
      : course_(std::move(course)), floor_(std::move(floor)) {}

  const Course& course() const { return *course_; }
  double length_m() const { return course_->length_m(); }
  std::size_t stations() const { return course_->stations().size(); }
  Pose2 station(std::size_t station) const { return pose(course_->stations()[station].at_m, {station}); }
  /// Returns a pose on the course, or on the sidings of `through` where one is passed; it looks along the path.
  Pose2 pose(double along_m, const std::vector<std::size_t>& through) const;
  std::vector<agents::SitePoint> line(double from_m, double to_m, const std::vector<std::size_t>& through) const;
  /// Names a spot: so far along the course, on the sidings of `through`.
  struct Spot {
    double at_m = 0.0;
    std::vector<std::size_t> through;
  };
  /// Returns the spot nearest to a robot of those that lead more or less where it looks.
  Spot nearest(const Pose2& site_from_robot) const;
  /// Returns what stands within the camera's view of a robot, without noise; `mark` as the robot reads it.
  std::vector<agents::Marks::Sighting> seen_from(const Pose2& site_from_robot) const {
    return floor_.seen_from(site_from_robot);
  }

 private:
  double right_m(double along_m, const std::vector<std::size_t>& through) const;

  std::unique_ptr<const Course> course_;
  MarkedFloor floor_;
};

/// Returns what a robot's camera reads there, with its noise.
agents::Marks read_marks(const Site& site, const Pose2& site_from_robot, Random& random);

/// Returns the names of all sites.
const std::vector<std::string>& site_names();
/// Makes the site of that name, which must be one of them.
Site make_site(std::string_view name, Random random);
/// Makes a site of aisles on a grid, large enough for so many robots.
Site make_large_site(std::size_t robots, Random random);
inline constexpr std::size_t kMostTaught = 8;    ///< robots that have room on a named site
inline constexpr std::size_t kMostStored = 200;  ///< and on a large one

}  // namespace weft::simulation
