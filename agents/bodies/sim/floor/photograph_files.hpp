#pragma once
#include <filesystem>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace weft::agents::sim {

/// Holds a photograph of floor, grey, at kTexelM a pixel.
struct Photograph {
  std::string name;   ///< of the file, without ending
  cv::Mat grey;       ///< CV_8U
  double mean = 0.0;  ///< of its grey under white light
};

/// Reads a folder's photographs, sorted by name. Errors and `warn` as make_photographed_floor says.
Result<std::vector<Photograph>> read_photographs(const std::string& folder, const std::string& only,
                                                 double light_warmth,
                                                 const std::function<void(const std::string&)>& warn);

/// Lists a folder's pictures, sorted. not_found: the folder, as `what` calls it, or there is none in it.
Result<std::vector<std::filesystem::path>> pictures_in(const std::string& folder, const std::string& what);
/// Reads a picture as a grey camera sees it under light of that colour. Errors are those of images::read.
Result<cv::Mat> read_grey(const std::filesystem::path& path, double light_warmth);

}  // namespace weft::agents::sim
