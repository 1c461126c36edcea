#pragma once
#include <cstdint>
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/perception/view.hpp"
#include "core/geometry/pose2.hpp"
#include "core/random.hpp"

namespace weft::simulation {

/// A one-way ring of aisles with a siding at each station, and numbered marks all over the floor. Metres; the ring is
/// driven counter-clockwise. Some marks carry a number that another one carries too.
class RingSite {
 public:
  explicit RingSite(Random random);

  double length_m() const { return length_m_; }
  std::size_t stations() const { return stations_.size(); }
  /// Where station k is, as a distance along the ring.
  double station_m(std::size_t station) const { return stations_[station]; }
  /// On the ring, or on the sidings of `through` where one is passed; the pose looks along the path.
  Pose2 pose(double along_m, const std::vector<std::size_t>& through) const;
  std::vector<agents::SitePoint> line(double from_m, double to_m, const std::vector<std::size_t>& through) const;
  /// What stands within the camera's view of a robot, without noise; `mark` as the robot reads it.
  std::vector<agents::Marks::Sighting> seen_from(const Pose2& site_from_robot) const;

 private:
  struct Mark {
    std::uint64_t number = 0;
    Pose2 site_from_mark;
  };
  Pose2 on_ring(double along_m) const;
  double offset_m(double along_m, const std::vector<std::size_t>& through) const;

  double length_m_ = 0.0;
  std::vector<double> stations_;
  std::vector<std::vector<Mark>> cells_;
};

}  // namespace weft::simulation
