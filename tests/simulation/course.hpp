#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace weft::simulation {

/// Describes a spot that robots are sent to: so far along the course, and beside it where a siding leads past.
struct Station {
  double at_m = 0.0;
  double right_m = 0.0;  ///< of the course, in its siding; negative: left; 0: on the course itself
};

/// Tells what one robot is taught: a stretch of the course, through these stations' sidings and past all others.
struct Lesson {
  double from_m = 0.0;
  double to_m = 0.0;
  std::vector<std::size_t> through;
};

/// Describes the one closed way of a site that holds all its lanes, in the order and direction in which they are
/// driven. It may come by one spot several times. Distances are metres along it, taken modulo its length.
class Course {
 public:
  virtual ~Course() = default;
  virtual const std::string& name() const = 0;
  virtual double length_m() const = 0;
  /// Returns the point and the direction of the course there.
  virtual Pose2 at(double along_m) const = 0;
  virtual const std::vector<Station>& stations() const = 0;
  /// Returns where a robot of so many stands at first.
  virtual double start_m(std::size_t robot, std::size_t robots) const = 0;
  /// Returns its lesson from where it stands at first. All lessons together hold the whole course and every station.
  virtual Lesson lesson(std::size_t robot, std::size_t robots) const = 0;
};

}  // namespace weft::simulation
