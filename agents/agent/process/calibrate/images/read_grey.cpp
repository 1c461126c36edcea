#include "agents/agent/process/calibrate/images/read_grey.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace weft::agents {

std::optional<Image> read_grey(const std::string& file) try {
  const cv::Mat grey = cv::imread(file, cv::IMREAD_GRAYSCALE);
  if (grey.empty()) return std::nullopt;
  return Image{grey.cols, grey.rows, std::make_shared<Bytes>(grey.datastart, grey.dataend)};
} catch (const cv::Exception&) {
  return std::nullopt;
}

}  // namespace weft::agents
