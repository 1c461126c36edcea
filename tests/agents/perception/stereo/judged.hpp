#pragma once
// Judges a disparity map, and OpenCV's beside it.
#include <cmath>
#include <cstddef>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <vector>

#include "agents/perception/opencv_view.hpp"
#include "agents/perception/stereo/disparity.hpp"

namespace weft::test {

/// Compares a map with true depths, where these are within what was searched: in the columns from `disparities` on,
/// where OpenCV tells anything, and not nearer.
struct Judged {
  double density = 0.0;
  double off_1px = 0.0, off_2px = 0.0;  ///< shares of what is told
  double mean_px = 0.0;                 ///< of what is told
};
inline Judged judged(const agents::DisparityMap& map, const agents::StereoRig& rig,
                     const std::vector<double>& depth_m, int disparities) {
  Judged found;
  std::size_t all = 0;
  std::size_t told = 0;
  for (int row = 0; row < map.height; ++row)
    for (int column = disparities; column < map.width; ++column) {
      const double truth = rig.disparity_px(depth_m[static_cast<std::size_t>(row * map.width + column)]);
      if (truth > disparities - 2) continue;
      ++all;
      const auto disparity = map.at(column, row);
      if (!disparity) continue;
      ++told;
      const double off = std::abs(*disparity - truth);
      found.mean_px += off;
      found.off_1px += off > 1.0 ? 1.0 : 0.0;
      found.off_2px += off > 2.0 ? 1.0 : 0.0;
    }
  found.density = static_cast<double>(told) / static_cast<double>(all);
  for (double* sum : {&found.off_1px, &found.off_2px, &found.mean_px}) *sum /= static_cast<double>(told);
  return found;
}

/// Returns OpenCV's semi-global matcher along three paths, with the penalties that its documentation proposes and the
/// checks that ours has.
inline cv::Ptr<cv::StereoSGBM> sgbm_matcher(int disparities) {
  constexpr int block = 5;
  return cv::StereoSGBM::create(0, disparities, block, 8 * block * block, 32 * block * block, 1, 31, 5, 100, 1,
                                cv::StereoSGBM::MODE_SGBM_3WAY);
}

inline agents::DisparityMap sgbm_map(const cv::Mat& disparity) {
  agents::DisparityMap map{disparity.cols, disparity.rows, {}};
  for (const std::int16_t value : cv::Mat_<std::int16_t>(disparity))
    map.sixteenths.push_back(value < 0 ? agents::DisparityMap::none : value);
  return map;
}

inline agents::DisparityMap sgbm(const agents::StereoPair& pair, int disparities) {
  cv::Mat disparity;
  sgbm_matcher(disparities)->compute(agents::as_mat(pair.left), agents::as_mat(pair.right), disparity);
  return sgbm_map(disparity);
}

}  // namespace weft::test
