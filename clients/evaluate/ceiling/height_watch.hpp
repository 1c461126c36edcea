#pragma once
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "agents/methods/ceiling/ceiling.hpp"

namespace weft::evaluate::ceiling {

/// Holds a corner's height as the method has it, and where it was seen.
struct SeenHeight {
  std::size_t sample = 0;                             ///< of the drive
  Eigen::Vector2d in_view = Eigen::Vector2d::Zero();  ///< undistorted, normalised
  agents::Height height;
};

/// Notes the height of each corner once, when it has been followed for so many metres of travel.
class HeightWatch {
 public:
  explicit HeightWatch(agents::Ceiling method, double from_m = 1.0) : method_(std::move(method)), from_m_(from_m) {}

  /// Takes note of the odometry after that sample.
  void look(std::size_t sample, const agents::Ceiling::Odometry& odometry);
  const std::vector<SeenHeight>& seen() const { return seen_; }

 private:
  using InView = std::pair<double, double>;
  static InView key_of(const Eigen::Vector2d& in_view) { return {in_view.x(), in_view.y()}; }

  agents::Ceiling method_;
  double from_m_;
  std::map<InView, double> travelled_m_;  ///< by each corner's place in the keyframe; of those noted: -infinity
  std::vector<SeenHeight> seen_;
};

}  // namespace weft::evaluate::ceiling
