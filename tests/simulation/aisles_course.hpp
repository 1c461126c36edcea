#pragma once
#include <string>
#include <vector>

#include "tests/simulation/course.hpp"

namespace weft::simulation {

/// One aisle that is driven both ways, turning round at both of its ends, and a lane that leaves it, crosses it at 90
/// degrees and joins it again. Every robot is taught a part, so that no run holds all lanes. Two stations stand in
/// the aisle at one spot, one for each direction; the others have sidings.
class AislesCourse : public Course {
 public:
  AislesCourse();

  const std::string& name() const override { return name_; }
  double length_m() const override { return length_m_; }
  Pose2 at(double along_m) const override;
  const std::vector<Station>& stations() const override { return stations_; }
  double start_m(std::size_t robot, std::size_t robots) const override;
  Lesson lesson(std::size_t robot, std::size_t robots) const override;

 private:
  /// A straight or an arc.
  struct Bend {
    double length_m = 0.0;
    double turn_rad = 0.0;  ///< left is positive
    double from_m = 0.0;
    Pose2 start;
  };

  void go(double metres);
  void turn(double degrees, double radius_m);
  void turn_round();
  void add(double length_m, double turn_rad);
  /// `along_m` is of the last bend.
  void station(double along_m, double right_m);

  std::string name_ = "aisles";
  double length_m_ = 0.0;
  std::vector<Bend> bends_;
  std::vector<Station> stations_;
};

}  // namespace weft::simulation
