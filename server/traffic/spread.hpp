#pragma once
#include <array>

#include "core/network/network.hpp"

namespace weft::server {

/// Bounds where two places may lie: anywhere within so many standard deviations.
inline constexpr double kLayoutSigmas = 3.0;

/// Tells how uncertain a pose in a frame is: the covariance of the twist that moves it, read in that frame, order (x,
/// y, heading). Along a chain of relations these add up, so the part of a chain below a place is a difference.
class Spread {
 public:
  Spread() = default;
  explicit Spread(const Eigen::Matrix3d& covariance);
  Eigen::Matrix3d matrix() const;
  /// Returns what comes on top of `earlier`, which lies on the same chain.
  Spread since(const Spread& earlier) const;
  /// Returns the covariance of the position that a point of the frame has.
  Eigen::Matrix2d at(const Eigen::Vector2d& point) const;
  double heading_variance_rad2() const { return upper_[5]; }
  bool operator==(const Spread&) const = default;

 private:
  std::array<double, 6> upper_{};  // xx, xy, xh, yy, yh, hh
};

/// Returns an edge as it is laid out in the plane. Where only the distance along a path is known the way bends evenly
/// from one heading to the other, and may have bent at once or at the end.
Metric2 laid_flat(const Relation& relation);

/// Returns how much less certain an edge makes what lies behind it: positive, and the same from either side.
double uncertainty_of(const Edge& edge);

/// Returns the largest standard deviation of a position.
double largest_sigma_m(const Eigen::Matrix2d& covariance);

/// Returns how much farther than to first order positions may be off, as a share of their largest standard deviation:
/// what is turned by an uncertain heading lies on an arc and not on a straight line.
double share_of_bend(double heading_variance_rad2);

/// Returns the least distance that two positions have, `apart` being the difference of their means, when both lie
/// within three standard deviations.
double least_distance_m(const Eigen::Vector2d& apart, const Eigen::Matrix2d& covariance, double bend);

}  // namespace weft::server
