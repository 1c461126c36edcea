#pragma once
#include <optional>
#include <vector>

#include "clients/evaluate/floor/trace.hpp"
#include "core/geometry/pose3.hpp"
#include "storage/formats/trajectory.hpp"

/// Lays a recording's trajectory beside what a robot inferred. Pure.
namespace weft::evaluate::floor {

/// Returns the pose at a time: between its two neighbours, positions linearly and rotations spherically. None outside
/// of the trajectory, and between neighbours more than `gap_s` apart.
std::optional<Pose3> at_time(const formats::Trajectory& trajectory, double time_s, double gap_s = 0.2);

/// Returns the rotation and translation, without scale, that lay points on others with the least squares (Umeyama
/// 1991). Needs at least two points, as many of the one as of the other.
Pose3 a_from_b_of(const std::vector<Eigen::Vector3d>& in_a, const std::vector<Eigen::Vector3d>& in_b);

/// Holds a trace with its truth, and how well the two fit.
struct Associated {
  Trace trace;                  ///< the samples that have a truth: in the plane, in the frame of the odometry's start
  double rmse_m = 0.0;          ///< of the positions after alignment
  double out_of_plane_m = 0.0;  ///< RMS of the truth's height over the plane
  double heading_offset_rad = 0.0;  ///< of the trajectory's body against the robot, taken out
  Pose3 start_from_truth;
};
/// Joins them by time; aligned over all samples with a truth. None: fewer than ten, or they do not move by 0.1 m.
std::optional<Associated> associate(const Trace& trace, const formats::Trajectory& trajectory);

/// Returns the samples of another run that have a truth, laid in the same frame.
Trace in_frame_of(const Associated& associated, const Trace& trace, const formats::Trajectory& trajectory);

}  // namespace weft::evaluate::floor
