#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "core/geometry/pose2.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Describes a place of a taught run, in the plane of the run's map.
struct MosaicPlace {
  Pose2 map_from_place;
  Attitude attitude;  ///< of the robot when it was there
  /// Bounds the attitude beforehand, 1 sigma: pitch and roll in rad, height in m; each > 0.
  Eigen::Vector3d attitude_sigma = Eigen::Vector3d(0.003, 0.003, 0.002);
};

/// Describes a corner of the ceiling, or of what hangs below it.
struct MosaicPoint {
  Eigen::Vector3d in_map = Eigen::Vector3d::Zero();  ///< m; z above the floor
  double told_m = 0.0;                               ///< its z as it was told beforehand...
  double told_sigma_m = 0.8;                         ///< ...and how well, > 0
  double height_sigma_m = 0.0;                       ///< of its z, once it is adjusted
};

/// Says that a point was seen from a place.
struct MosaicSighting {
  std::uint32_t place = 0;                         ///< index
  std::uint32_t point = 0;                         ///< index
  Eigen::Vector3d ray = Eigen::Vector3d::UnitZ();  ///< unit, in the camera's frame, its lens undone
  double sigma_rad = 0.001;                        ///< > 0, of the ray, each way
};

/// Relates two places by something else than what is sighted: odometry, or a stitch, which may be wrong.
struct MosaicLink {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  Pose2 from_from_to;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of xi in from_from_to * se2_exp(xi)
  bool is_stitch = false;
};

/// Holds a taught run as what was seen above it: the places in the order in which they were driven, and all that
/// binds them (Lucas et al., II.D, where a chain of homographies did).
struct Mosaic {
  Pose3 robot_from_camera;  ///< one camera saw all of it
  std::vector<MosaicPlace> places;
  std::vector<MosaicPoint> points;
  std::vector<MosaicSighting> sightings;
  std::vector<MosaicLink> links;  ///< of neighbours in the order of driving, and stitches of any two
};

/// Returns where the ray of a sighting meets the height, as its place stands; none: it never does.
std::optional<Eigen::Vector3d> met(const Mosaic& mosaic, const MosaicSighting& sighting, double height_m);

/// Names what is wrong with a mosaic, and where; empty: nothing is.
std::string problem_of(const Mosaic& mosaic);

}  // namespace weft::agents
