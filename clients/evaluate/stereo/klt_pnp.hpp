#pragma once
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "agents/perception/stereo/stereo_rig.hpp"
#include "agents/perception/view.hpp"

namespace weft::evaluate::stereo {

/// Says how corners are found: Shi & Tomasi's, or the strongest of FAST's, which are found sooner.
enum class KltCorners { shi_tomasi, fast };

/// Is the visual odometry that one puts together of OpenCV's parts: corners, followed by Lucas & Kanade into the
/// right image and into the next left one, and the pose by solvePnPRansac, refined over its inliers. Each pair is
/// compared with the one before.
class KltPnp {
 public:
  explicit KltPnp(const agents::StereoRig& rig, KltCorners corners = KltCorners::shi_tomasi)
      : rig_(rig), found_by_(corners) {}

  /// Returns how the left camera has moved since the pair before: previous_from_current. The images are rectified and
  /// whole. None: it is the first one, or fewer than ten corners agree.
  std::optional<Pose3> step(const agents::StereoPair& pair);

 private:
  void remember(const cv::Mat& left, const cv::Mat& right);
  std::optional<Pose3> pose_in(const cv::Mat& left) const;

  agents::StereoRig rig_;
  KltCorners found_by_;
  cv::Mat left_;                      // of the pair before
  std::vector<cv::Point2f> corners_;  // in it
  std::vector<cv::Point3f> points_;   // of the corners, in its camera's frame
};

}  // namespace weft::evaluate::stereo
