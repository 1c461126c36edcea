#pragma once
#include <string>
#include <vector>

#include "tests/simulation/bends.hpp"
#include "tests/simulation/course.hpp"

namespace weft::simulation {

/// Describes one aisle that is driven both ways, turning round at both of its ends, and a lane that leaves it,
/// crosses it at 90 degrees and joins it again. Every robot is taught a part, so that no run holds all lanes. Two
/// stations stand in the aisle at one spot, one for each direction; the others have sidings.
class AislesCourse : public Course {
 public:
  AislesCourse();

  const std::string& name() const override { return name_; }
  double length_m() const override { return bends_.length_m(); }
  Pose2 at(double along_m) const override { return bends_.at_modulo(along_m); }
  const std::vector<Station>& stations() const override { return stations_; }
  double start_m(std::size_t robot, std::size_t robots) const override;
  Lesson lesson(std::size_t robot, std::size_t robots) const override;

 private:
  /// Adds a station; `along_m` is of the way that has been laid out.
  void station(double along_m, double right_m) { stations_.push_back({along_m, right_m}); }

  std::string name_ = "aisles";
  Bends bends_;
  std::vector<Station> stations_;
};

}  // namespace weft::simulation
