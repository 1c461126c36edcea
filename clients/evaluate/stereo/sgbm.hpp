#pragma once
#include <opencv2/calib3d.hpp>

#include "agents/perception/stereo/disparity.hpp"

/// Holds what stereo of ours is measured beside, and the measuring.
namespace weft::evaluate::stereo {

/// Returns OpenCV's semi-global matcher along three paths, with the penalties that its documentation proposes and the
/// checks that ours has.
cv::Ptr<cv::StereoSGBM> sgbm_matcher(int disparities);

/// Returns what the matcher has computed, as ours has it.
agents::DisparityMap sgbm_map(const cv::Mat& disparity);

/// Matches a rectified pair by it. Both images are whole.
agents::DisparityMap sgbm(const agents::StereoPair& pair, int disparities);

}  // namespace weft::evaluate::stereo
