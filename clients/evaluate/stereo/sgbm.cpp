#include "clients/evaluate/stereo/sgbm.hpp"

#include "agents/perception/opencv_view.hpp"

namespace weft::evaluate::stereo {

cv::Ptr<cv::StereoSGBM> sgbm_matcher(int disparities) {
  constexpr int block = 5;
  return cv::StereoSGBM::create(0, disparities, block, 8 * block * block, 32 * block * block, 1, 31, 5, 100, 1,
                                cv::StereoSGBM::MODE_SGBM_3WAY);
}

agents::DisparityMap sgbm_map(const cv::Mat& disparity) {
  agents::DisparityMap map{disparity.cols, disparity.rows, {}};
  for (const std::int16_t value : cv::Mat_<std::int16_t>(disparity))
    map.sixteenths.push_back(value < 0 ? agents::DisparityMap::none : value);
  return map;
}

agents::DisparityMap sgbm(const agents::StereoPair& pair, int disparities) {
  cv::Mat disparity;
  sgbm_matcher(disparities)->compute(agents::as_mat(pair.left), agents::as_mat(pair.right), disparity);
  return sgbm_map(disparity);
}

}  // namespace weft::evaluate::stereo
