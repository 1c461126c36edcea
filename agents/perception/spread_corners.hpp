#pragma once
// Private to the rooms that compute with OpenCV; never included by a public header.
#include <opencv2/core.hpp>
#include <vector>

namespace weft::agents {

/// Returns at most `count` of the corners, the strongest of each cell of a grid of `columns` x `rows` in turn: a
/// corner in an empty stretch tells more than one more in a crowd.
std::vector<cv::KeyPoint> spread_corners(std::vector<cv::KeyPoint> found, const cv::Size& size, int columns, int rows,
                                         int count);

}  // namespace weft::agents
