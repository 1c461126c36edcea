#pragma once
#include <map>
#include <vector>

#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/floor/taught_path.hpp"
#include "clients/evaluate/floor/trace.hpp"

/// Computes what traces come to. All pure; NaN where there was nothing to measure.
namespace weft::evaluate::floor {

/// Holds the speeds over five frames, as the paper averages them (figure 6b); both over the same true time.
struct SpeedWindow {
  double true_s = 0.0;  ///< its middle
  double v_m_s = 0.0;
  double v_true_m_s = 0.0;
  double v_stamped_m_s = 0.0;  ///< by the samples' own stamps, with their jitter
};
/// Returns consecutive windows, those in which it really moved by more than 0.1 m/s.
std::vector<SpeedWindow> speed_windows(const Trace& trace);

/// States the mean |v - v_true| / mean v_true, percent.
struct SpeedError {
  double percent;
  double stamped_percent;  ///< with speeds by the samples' own stamps
};
SpeedError speed_error(const Trace& trace);

/// Tells how fast odometry and the fixes say that it drove between two fixes, at least half a metre apart (the
/// paper's spacing of places). A fix counts as it was measured, before it was weighed against odometry.
struct FixedStretch {
  double true_s = 0.0;
  double v_odometry_m_s = 0.0;
  double v_fixes_m_s = 0.0;
};
std::vector<FixedStretch> fixed_stretches(const Trace& trace, const std::map<PlaceId, Pose2>& start_from_place);
/// Returns the mean |v_odometry - v_fixes| / mean v_odometry, percent (figure 8).
double consistency_percent(const std::vector<FixedStretch>& stretches);

/// Returns the true metres driven between consecutive fixes that are right within 0.05 m and 2 degrees, from the
/// start to the first one and from the last one to the end included. Never empty for a trace that is not.
std::vector<double> blind_distances(const Trace& trace, const std::map<PlaceId, Pose2>& site_from_place);

/// Returns how many fixes are off by more than 0.10 m or 3 degrees, as measured or as believed.
double wrong_fixes(const Trace& trace, const std::map<PlaceId, Pose2>& site_from_place);
double fixes(const Trace& trace);

/// Holds a stretch of the drive by odometry, its steps' covariances composed as navigation composes them.
struct Stretch {
  Eigen::Vector3d off = Eigen::Vector3d::Zero();  ///< the true motion in the frame of odometry's (x, y, heading)
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};
/// Returns stretches of so many true metres; a new one begins each tenth of it.
std::vector<Stretch> stretches(const Trace& trace, double metres);
/// Returns the squared Mahalanobis distance of the truth, of each stretch.
std::vector<double> distances2(const std::vector<Stretch>& stretches);
/// Returns the share of them within the 95 % region (chi square with three degrees of freedom), percent.
double held_percent(const std::vector<double>& distances2);

/// Compares the true pose with the true taught path, from one metre of driving on.
struct OffPath {
  double true_s = 0.0;
  double driven_m = 0.0;
  double lateral_m = 0.0;
  double heading_rad = 0.0;
  bool moves = false;  ///< by more than 0.1 m/s: not the creeping at the goal
};
std::vector<OffPath> off_path(const Trace& trace, const TaughtPath& path);

struct PathErrors {
  double lateral_rmse_m;
  double lateral_worst_m;
  double heading_rms_rad;  ///< while it moves
};
PathErrors path_errors(const std::vector<OffPath>& off);

}  // namespace weft::evaluate::floor
