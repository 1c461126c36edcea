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
  /// Returns what stands within the camera's view of a robot, without noise; `mark` as the robot reads it.
  std::vector<agents::Marks::Sighting> seen_from(const Pose2& site_from_robot) const {
    return floor_.seen_from(site_from_robot);
  }

 private:
  double right_m(double along_m, const std::vector<std::size_t>& through) const;

  std::unique_ptr<const Course> course_;
  MarkedFloor floor_;
};

/// The names of all sites.
const std::vector<std::string>& site_names();
/// `name` is one of them.
Site make_site(std::string_view name, Random random);

}  // namespace weft::simulation
