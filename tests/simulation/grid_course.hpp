#pragma once
#include <string>
#include <vector>

#include "tests/simulation/bends.hpp"
#include "tests/simulation/course.hpp"

namespace weft::simulation {

/// Lays aisles on a grid, as many as so many robots want: each one lane that is driven both ways, crossings that are
/// driven straight and by turns, dead ends with room to turn for one robot. Every lane comes twice, so that lanes
/// lead on in more than one way. Stations are in the aisles and at the dead ends; none has a siding.
class GridCourse : public Course {
 public:
  explicit GridCourse(std::size_t robots);

  const std::string& name() const override { return name_; }
  double length_m() const override { return bends_.length_m(); }
  Pose2 at(double along_m) const override { return bends_.at_modulo(along_m); }
  const std::vector<Station>& stations() const override { return stations_; }
  double start_m(std::size_t robot, std::size_t robots) const override;
  /// Returns the whole course, through all stations.
  Lesson lesson(std::size_t robot, std::size_t robots) const override;
  /// Return how far the aisles reach: from (0, 0), dead ends beyond.
  double east_m() const;
  double north_m() const;
  std::size_t dead_ends() const { return dead_ends_; }

 private:
  /// Names a way into or out of a crossing: east, north, west, south, counted from the crossing.
  struct Arm {
    std::size_t crossing = 0;
    std::size_t side = 0;
    auto operator<=>(const Arm&) const = default;
  };
  bool has(const Arm& arm) const { return !ends_dead(arm) || is_dead_end(arm); }
  /// Returns whether no other crossing lies that way.
  bool ends_dead(const Arm& arm) const;
  bool is_dead_end(const Arm& arm) const;
  Arm other_end(const Arm& arm) const;
  std::vector<std::size_t> ways_on(const Arm& arrived) const;
  std::vector<Arm> arms() const;
  std::vector<Arm> circuit() const;
  void lay(const std::vector<Arm>& circuit);

  std::string name_ = "aisles";
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::size_t dead_ends_ = 0;
  Bends bends_;
  std::vector<Station> stations_;
  std::vector<double> starts_;  ///< middles of aisles, each another one
};

}  // namespace weft::simulation
