#pragma once
#include <string>
#include <vector>

#include "tests/simulation/course.hpp"

namespace weft::simulation {

/// Describes a one-way ring of aisles with a siding at each station, driven counter-clockwise. Every robot is taught
/// the whole ring, through sidings of its own.
class RingCourse : public Course {
 public:
  RingCourse();

  const std::string& name() const override { return name_; }
  double length_m() const override { return length_m_; }
  Pose2 at(double along_m) const override;
  const std::vector<Station>& stations() const override { return stations_; }
  double start_m(std::size_t robot, std::size_t robots) const override;
  Lesson lesson(std::size_t robot, std::size_t robots) const override;

 private:
  std::string name_ = "ring";
  double length_m_ = 0.0;
  std::vector<Station> stations_;
};

}  // namespace weft::simulation
