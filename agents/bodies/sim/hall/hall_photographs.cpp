#include "agents/bodies/sim/hall/hall_photographs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <string_view>
#include <utility>

#include "agents/bodies/sim/floor/photograph_files.hpp"

namespace weft::agents::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, Stuff>, 9> kNames = {{{"floor", Stuff::floor},
                                                                       {"wall", Stuff::wall},
                                                                       {"ceiling", Stuff::ceiling},
                                                                       {"steel", Stuff::steel},
                                                                       {"load", Stuff::load},
                                                                       {"pallet", Stuff::pallet},
                                                                       {"sign", Stuff::sign},
                                                                       {"vehicle", Stuff::vehicle},
                                                                       {"clothing", Stuff::clothing}}};

Result<Stuff> stuff_of(const fs::path& folder) {
  std::string names;
  for (const auto& [name, stuff] : kNames) {
    if (folder.filename() == name) return stuff;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return fail(ErrorCode::invalid, folder.string() + ": nothing in a hall is called so; there are " + names);
}

Result<Texture> texture_of(const fs::path& picture, Stuff stuff) {
  const Result<cv::Mat> photograph = read_grey(picture, 0.0);
  if (!photograph) return fail(photograph.error());
  cv::Mat grey;
  const int side = is_fitted(stuff) ? 128 : 512;
  cv::resize(*photograph, grey, {side, side}, 0.0, 0.0, cv::INTER_AREA);
  grey.convertTo(grey, CV_8U, 128.0 / std::max(1.0, cv::mean(grey)[0]));
  return Texture(side, {grey.datastart, grey.dataend});
}

}  // namespace

Result<Photographed> read_hall_photographs(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  if (error) return fail(ErrorCode::not_found, "hall folder " + folder + ": " + error.message());
  if (folders.empty())
    return fail(ErrorCode::not_found, "hall folder " + folder + ": no folder of photographs in it");
  std::sort(folders.begin(), folders.end());
  Photographed photographed;
  for (const fs::path& one : folders) {
    const Result<Stuff> stuff = stuff_of(one);
    if (!stuff) return fail(stuff.error());
    const auto pictures = pictures_in(one.string(), "hall folder ");
    if (!pictures) return fail(pictures.error());
    for (const fs::path& picture : *pictures) {
      Result<Texture> texture = texture_of(picture, *stuff);
      if (!texture) return fail(texture.error());
      photographed[*stuff].push_back(std::move(*texture));
    }
  }
  return photographed;
}

}  // namespace weft::agents::sim
