#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "agents/agent/process/words.hpp"
#include "images/read.hpp"

namespace weft::agents {
namespace {

namespace fs = std::filesystem;

Result<std::vector<fs::path>> images_in(const std::string& folder) {
  std::error_code problem;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    std::string ending = entry.path().extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    constexpr std::array kEndings = {".png", ".jpg", ".jpeg", ".pgm"};
    if (std::ranges::find(kEndings, ending) != kEndings.end()) files.push_back(entry.path());
  }
  if (problem)
    return fail(ErrorCode::not_found, folder + ": " + problem.message() + "; give the folder of the images");
  if (files.empty())
    return fail(ErrorCode::not_found, folder + ": no .png, .jpg, .jpeg or .pgm in it; give the folder of the images");
  std::ranges::sort(files);
  return files;
}

/// Holds the findings in the images: boards, and why the other images are of no use.
struct Found {
  std::vector<BoardImage> boards;
  std::vector<std::pair<int, int>> sizes;                    ///< of each
  std::vector<std::pair<std::string, std::string>> useless;  ///< file, why
  int width = 0;
  int height = 0;
};

void look_at(const fs::path& file, const Board& board, Found& found) {
  const std::string name = file.filename().string();
  Result<images::Picture> grey = images::read(file, images::Shades::grey);
  if (!grey) {
    found.useless.emplace_back(name, grey.error().message);
    return;
  }
  const Image image{grey->width, grey->height, std::make_shared<Bytes>(std::move(grey->samples))};
  if (auto sighting = find_board(image, board)) {
    found.boards.push_back({name, std::move(*sighting)});
    found.sizes.emplace_back(image.width, image.height);
  } else {
    found.useless.emplace_back(name, "no board was found in it");
  }
}

/// Keeps images of one size, that of most images with a board: one camera has one size.
void keep_one_size(Found& found) {
  std::pair<int, int> size;
  std::ptrdiff_t most = 0;
  for (const std::pair<int, int>& one : found.sizes) {
    if (const auto count = std::ranges::count(found.sizes, one); count > most) {
      size = one;
      most = count;
    }
  }
  found.width = size.first;
  found.height = size.second;
  std::vector<BoardImage> kept;
  for (std::size_t i = 0; i < found.boards.size(); ++i) {
    if (found.sizes[i] == size) {
      kept.push_back(std::move(found.boards[i]));
    } else {
      found.useless.emplace_back(found.boards[i].name,
                                 text("is %d x %d pixels, most are %d x %d", found.sizes[i].first,
                                      found.sizes[i].second, size.first, size.second));
    }
  }
  found.boards = std::move(kept);
}

Found look_at_all(const std::vector<fs::path>& files, const Board& board, const JobOutput& output) {
  constexpr double kBetweenLines = 2.0;
  Found found;
  double said_s = output.now_s();
  for (std::size_t i = 0; i < files.size(); ++i) {
    look_at(files[i], board, found);
    if (output.now_s() - said_s < kBetweenLines) continue;
    said_s = output.now_s();
    output.err << i + 1 << " of " << files.size() << " images, the board in " << found.boards.size() << " of them"
               << std::endl;
  }
  keep_one_size(found);
  return found;
}

std::string words_of(const Board& board) {
  if (const auto* chess = std::get_if<ChessBoard>(&board))
    return text("chessboard %dx%d, squares of %g mm", chess->columns, chess->rows, 1e3 * chess->square_m);
  const auto& tags = std::get<TagBoard>(board);
  return text("AprilTags %dx%d of %g mm, gaps of %g mm", tags.columns, tags.rows, 1e3 * tags.tag_m, 1e3 * tags.gap_m);
}

void print_table(const CameraFit& fit, const Found& found, std::ostream& out) {
  std::size_t widest = 5;
  for (const ImageFit& image : fit.images) widest = std::max(widest, image.name.size());
  for (const auto& [name, why] : found.useless) widest = std::max(widest, name.size());
  const auto row = [&](const std::string& name, const std::string& rest) {
    out << name << std::string(widest + 2 - name.size(), ' ') << rest << '\n';
  };
  row("image", "points  RMS px");
  for (const ImageFit& image : fit.images)
    row(image.name, text("%6zu  %6.2f%s", image.pixels.size(), image.rms_px,
                         image.used ? "" : "  disagrees with the others, left out"));
  for (const auto& [name, why] : found.useless) row(name, "     -       -  " + why);
}

void print_camera(const CameraFit& fit, std::ostream& out) {
  const CameraCalibration& c = fit.camera;
  const auto used = std::ranges::count_if(fit.images, &ImageFit::used);
  out << text("RMS %.3f px over %td images; the board was in %.0f %% of the image, tilted by up to %.0f degrees\n",
              fit.rms_px, used, 100.0 * fit.cover, fit.tilt_rad * 180.0 / 3.14159265358979);
  out << text("%s  fx %.2f  fy %.2f  cx %.2f  cy %.2f px  distortion %.5f %.5f %.5f %.5f\n", to_string(c.lens), c.fx,
              c.fy, c.cx, c.cy, c.distortion[0], c.distortion[1], c.distortion[2], c.distortion[3]);
  out << text("one sigma: focal length %.2f %%, optical centre %.2f px, lens %.2f px in the image's corner\n",
              100.0 * *c.sigma.focal_share, *c.sigma.centre_px, *c.sigma.distortion_px);
}

nlohmann::ordered_json document_of(const CameraFit& fit, const Found& found, const CameraJob& job) {
  const CameraCalibration& c = fit.camera;
  nlohmann::ordered_json images = nlohmann::ordered_json::array();
  for (const ImageFit& image : fit.images)
    images.push_back(
        {{"file", image.name}, {"points", image.pixels.size()}, {"rms_px", image.rms_px}, {"used", image.used}});
  for (const auto& [name, why] : found.useless) images.push_back({{"file", name}, {"used", false}, {"why", why}});
  return {{"model", to_string(c.lens)},
          {"width", c.width},
          {"height", c.height},
          {"intrinsics", {c.fx, c.fy, c.cx, c.cy}},
          {"distortion", c.distortion},
          {"rms_px", fit.rms_px},
          {"focal_sigma_share", *c.sigma.focal_share},
          {"centre_sigma_px", *c.sigma.centre_px},
          {"distortion_sigma_px", *c.sigma.distortion_px},
          {"cover", fit.cover},
          {"tilt_rad", fit.tilt_rad},
          {"images", images},
          {"camera_file", job.out},
          {"picture", job.picture}};
}

}  // namespace

Result<void> calibrate_camera(const CameraJob& job, const JobOutput& output) {
  const Result<std::vector<fs::path>> files = images_in(job.folder);
  if (!files) return fail(files.error());
  const Found found = look_at_all(*files, job.board, output);
  CameraFitConfig config;
  config.lens = job.lens;
  const Result<CameraFit> fit = fit_camera(found.boards, found.width, found.height, config);
  if (!fit) {
    for (const auto& [name, why] : found.useless) output.err << name << ": " << why << '\n';
    return fail(fit.error().code, job.folder + ": " + fit.error().message);
  }
  const auto used = std::ranges::count_if(fit->images, &ImageFit::used);
  std::ofstream file(job.out, std::ios::trunc);
  file << camera_file_text(
      fit->camera, {"by weft calibrate camera: " + words_of(job.board) + ", " + std::to_string(used) + " images",
                    text("reprojection error %.3f px RMS", fit->rms_px)});
  file.close();
  if (!file) return fail(ErrorCode::exhausted, job.out + ": cannot be written; is the folder there?");
  const Result<void> drawn = draw_residuals(*fit, words_of(job.board), job.picture);
  if (!drawn) return drawn;
  if (job.json) {
    output.out << document_of(*fit, found, job).dump(2) << '\n';
    return {};
  }
  print_table(*fit, found, output.out);
  print_camera(*fit, output.out);
  output.out << job.out << " holds the camera, " << job.picture << " its residuals\n";
  return {};
}

}  // namespace weft::agents
