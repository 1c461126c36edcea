#pragma once
#include "core/geometry/pose2.hpp"

namespace weft::agents {

struct SteeringConfig {
  double cross_track_gain_1_s = 1.0;   ///< k of Hoffmann et al. 2007, eq. 5; (0, 5]
  double softening_m_s = 0.15;         ///< added to the speed, so that standing does not divide by nothing; (0, 1]
  double heading_integral_1_s2 = 0.6;  ///< on what is left of the heading error where nothing is known of how far
                                       ///< aside the robot is: taught turns err as wheels do; [0, 5]
  double heading_gain_1_s = 3.5;   ///< turns the heading error into a rate; >= 3 k keeps it from swinging; (0, 10]
  double max_approach_rad = 0.7;   ///< steepest angle at which the path is approached; (0, 1.5]
  double max_angular_rad_s = 1.0;  ///< (0, 5]
};

/// Describes where the robot is against the path's nearest point: metres left of it, and heading turned left of it.
struct TrackError {
  double cross_track_m = 0.0;
  double heading_rad = 0.0;
};

/// Returns the error of a robot at `frame_from_robot` against a pose of the path in the same frame.
TrackError track_error(const Pose2& frame_from_path, const Pose2& frame_from_robot);

/// Returns the angular velocity, rad/s, that steers a differential drive as Hoffmann, Tomlin, Montemerlo & Thrun 2007
/// steer a car's wheel (angle psi + arctan(k e / v)): the path's own rate v * curvature, less a gain g on that angle.
/// Linearised e'' = -g e' - g k e: it does not swing for g >= 4 k. Limited to +- max_angular_rad_s.
double steer_rate(const SteeringConfig& config, const TrackError& error, double curvature_1_m, double speed_m_s);

}  // namespace weft::agents
