#pragma once
#include <vector>

#include "core/geometry/pose2.hpp"

namespace weft::simulation {

/// Holds a way that is laid out piece by piece: straights, and arcs that go on where the last one looks.
class Bends {
 public:
  explicit Bends(const Pose2& start) : start_(start) {}

  void go(double metres) { add(metres, 0.0); }
  /// Lays an arc; to the left is positive.
  void turn(double degrees, double radius_m);
  /// Leads back to where it began, the other way, round a bulb. Returns where along the way its far end lies.
  double turn_round(double radius_m);
  double length_m() const { return bends_.empty() ? 0.0 : bends_.back().from_m + bends_.back().length_m; }
  /// Returns point and direction at a distance from the beginning, in [0, length_m()].
  Pose2 at(double along_m) const;
  /// Returns the same of a way that ends where it begins, at any distance: modulo the length.
  Pose2 at_modulo(double along_m) const;

 private:
  struct Bend {
    double length_m = 0.0;
    double turn_rad = 0.0;
    double from_m = 0.0;
    Pose2 start;
  };

  void add(double length_m, double turn_rad);

  Pose2 start_;
  std::vector<Bend> bends_;
};

}  // namespace weft::simulation
