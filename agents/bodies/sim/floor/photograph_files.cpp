#include "agents/bodies/sim/floor/photograph_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "agents/bodies/sim/floor/source.hpp"
#include "core/config/config.hpp"
#include "images/read.hpp"

namespace weft::agents::sim {
namespace {

namespace fs = std::filesystem;

constexpr double kAssumedMmPerPixel = 0.7;
constexpr double kLeastMmPerPixel = 0.05;
constexpr double kMostMmPerPixel = 10.0;
constexpr int kLeastTexels = 320;  // 0.2 m: less is a pattern, not a floor

using Scales = std::map<std::string, double>;  // mm_per_pixel by file name

Result<std::string> read_text(const fs::path& path) {
  const std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) {
    return fail(ErrorCode::unavailable, path.string() + ": cannot be read");
  }
  return text.str();
}

double scale_in(const config::Table& table) {
  return table.number("mm_per_pixel", config::required, kLeastMmPerPixel, kMostMmPerPixel);
}

/// Reads the scale, mm a pixel, from FILE.toml beside a picture, its one key. Nothing when there is none.
Result<std::optional<double>> scale_beside(const fs::path& picture) {
  const fs::path sidecar = picture.string() + ".toml";
  if (!fs::exists(sidecar)) {
    return std::optional<double>();
  }
  auto text = read_text(sidecar);
  if (!text) {
    return fail(text.error());
  }
  const config::Table root = config::parse(*text, sidecar.string());
  const double scale = scale_in(root);
  if (auto checked = root.result(); !checked) {
    return fail(checked.error());
  }
  return std::optional<double>(scale);
}

/// Reads floors.toml: a table for each picture that it knows; tables are named as the pictures are, without ending.
Result<Scales> scales_in(const fs::path& folder, const std::vector<fs::path>& pictures) {
  Scales scales;
  const fs::path list = folder / "floors.toml";
  if (!fs::exists(list)) {
    return scales;
  }
  auto text = read_text(list);
  if (!text) {
    return fail(text.error());
  }
  const config::Table root = config::parse(*text, list.string());
  for (const fs::path& picture : pictures) {
    const std::string name = picture.stem().string();
    if (root.has(name)) {
      const config::Table entry = root.table(name);
      const std::string file = entry.text("file", picture.filename().string());
      if (!fs::exists(folder / file)) {
        entry.refuse("file", "there is no " + (folder / file).string());
      }
      scales[file] = scale_in(entry);
    }
  }
  // What was not asked for names a picture that is not there.
  if (auto checked = root.result(); !checked) {
    return fail(ErrorCode::not_found, checked.error().message + " (is its picture missing?)");
  }
  return scales;
}

bool is_picture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

Result<Photograph> read_photograph(const fs::path& path, double mm_per_pixel, double light_warmth) {
  const Result<cv::Mat> lit = read_grey(path, light_warmth);
  if (!lit) return fail(lit.error());
  const cv::Mat& grey = *lit;
  const Result<cv::Mat> white = light_warmth == 0.0 ? lit : read_grey(path, 0.0);
  if (!white) return fail(white.error());
  const double factor = mm_per_pixel * 1e-3 / kTexelM;
  const int width = static_cast<int>(std::lround(grey.cols * factor));
  const int height = static_cast<int>(std::lround(grey.rows * factor));
  if (std::min(width, height) < kLeastTexels) {
    return fail(ErrorCode::invalid, path.string() + ": shows less than 0.2 m of floor at " +
                                        std::to_string(mm_per_pixel) + " mm_per_pixel");
  }
  Photograph photograph{path.stem().string(), {}, cv::mean(*white)[0]};
  cv::resize(grey, photograph.grey, {width, height}, 0.0, 0.0, factor < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return photograph;
}

}  // namespace

Result<std::vector<fs::path>> pictures_in(const std::string& folder, const std::string& what) {
  std::error_code error;
  std::vector<fs::path> pictures;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_picture(entry.path())) {
      pictures.push_back(entry.path());
    }
  }
  if (error) {
    return fail(ErrorCode::not_found, what + folder + ": " + error.message());
  }
  if (pictures.empty()) {
    return fail(ErrorCode::not_found, what + folder + ": no .png or .jpg in it");
  }
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

Result<cv::Mat> read_grey(const fs::path& path, double light_warmth) {
  const bool is_white = light_warmth == 0.0;
  Result<images::Picture> picture = images::read(path, is_white ? images::Shades::grey : images::Shades::colours);
  if (!picture) return fail(picture.error());
  const cv::Mat shown(picture->height, picture->width, is_white ? CV_8UC1 : CV_8UC3, picture->samples.data());
  if (is_white) return shown.clone();
  // The weights of ITU-R BT.601, as grey under white light has them, under light that is more red or more blue.
  const double blue = 0.114 * (1.0 - light_warmth);
  const double green = 0.587;
  const double red = 0.299 * (1.0 + light_warmth);
  const double sum = blue + green + red;
  cv::Mat grey;
  cv::transform(shown, grey, cv::Matx13d(blue / sum, green / sum, red / sum));
  return grey;
}

Result<std::vector<Photograph>> read_photographs(const std::string& folder, const std::string& only,
                                                 double light_warmth,
                                                 const std::function<void(const std::string&)>& warn) {
  auto pictures = pictures_in(folder, "floors folder ");
  if (!pictures) {
    return fail(pictures.error());
  }
  auto scales = scales_in(folder, *pictures);
  if (!scales) {
    return fail(scales.error());
  }
  std::vector<Photograph> photographs;
  for (const fs::path& path : *pictures) {
    if (!only.empty() && path.stem() != only) {
      continue;
    }
    auto beside = scale_beside(path);
    if (!beside) {
      return fail(beside.error());
    }
    const auto listed = scales->find(path.filename().string());
    if (!*beside && listed == scales->end() && warn) {
      warn(path.string() + ": no mm_per_pixel in floors.toml or " + path.filename().string() + ".toml; 0.7 assumed");
    }
    auto photograph = read_photograph(path,
                                      *beside                   ? **beside
                                      : listed != scales->end() ? listed->second
                                                                : kAssumedMmPerPixel,
                                      light_warmth);
    if (!photograph) {
      return fail(photograph.error());
    }
    photographs.push_back(std::move(*photograph));
  }
  if (photographs.empty()) {
    return fail(ErrorCode::not_found,
                "floors folder " + folder + ": no picture named " + only + " (floor.photograph)");
  }
  return photographs;
}

}  // namespace weft::agents::sim
