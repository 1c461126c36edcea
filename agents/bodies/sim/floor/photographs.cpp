#include "agents/bodies/sim/floor/photographs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "agents/bodies/sim/floor/photograph_files.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kPatchM = 0.2;     // spacing of patches
constexpr double kFeatherM = 0.05;  // over which two patches fade into each other
constexpr double kRegionM = 4.0;    // of one photograph, with several
constexpr double kGloss = 12.0;

constexpr int kPatchSide = static_cast<int>((kPatchM + kFeatherM) / kTexelM);

/// Describes a patch of the quilt by what of which photograph it shows, and how it is turned.
struct Patch {
  std::size_t photograph = 0;
  double centre_x = 0.0, centre_y = 0.0;  ///< in the photograph, pixels
  double angle = 0.0;
};

std::uint64_t cell_seed(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  return seed * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(x) * 0xC2B2AE3D27D4EB4FULL ^
         static_cast<std::uint64_t>(y) * 0x165667B19E3779F9ULL;
}

class PhotographedFloor final : public FloorSource {
 public:
  PhotographedFloor(const FloorSetup& setup, std::vector<Photograph> photographs)
      : setup_(setup), photographs_(std::move(photographs)) {
    for (const Photograph& photograph : photographs_) {
      means_.push_back(static_cast<float>(photograph.mean));
    }
    ramp_.resize(kPatchSide);
    const double feather = kFeatherM / kTexelM;
    for (int i = 0; i < kPatchSide; ++i) {
      const double inside = std::min(i + 0.5, kPatchSide - i - 0.5);
      const double share = std::clamp(inside / feather, 0.0, 1.0);
      ramp_[static_cast<std::size_t>(i)] = static_cast<float>(share * share * (3.0 - 2.0 * share));
    }
  }

  void fill(TileKey key, std::span<std::uint8_t> texels) const override;
  double gloss() const override { return kGloss * setup_.gloss; }

 private:
  std::size_t photograph_at(double x, double y) const;
  Patch patch_of(std::int64_t cell_x, std::int64_t cell_y) const;
  void add(const Patch& patch, std::int64_t cell_x, std::int64_t cell_y, TileKey key, cv::Mat& sum,
           cv::Mat& weights) const;

  FloorSetup setup_;
  std::vector<Photograph> photographs_;
  std::vector<float> means_;
  std::vector<float> ramp_;  ///< weight along one side of a patch
};

/// Returns the photograph of the nearest of jittered region centres.
std::size_t PhotographedFloor::photograph_at(double x, double y) const {
  const auto cx = static_cast<std::int64_t>(std::floor(x / kRegionM));
  const auto cy = static_cast<std::int64_t>(std::floor(y / kRegionM));
  double best = 1e18;
  std::size_t chosen = 0;
  for (std::int64_t j = cy - 1; j <= cy + 1; ++j) {
    for (std::int64_t i = cx - 1; i <= cx + 1; ++i) {
      Random random(cell_seed(setup_.seed + 77, i, j));
      const double px = (static_cast<double>(i) + random.uniform()) * kRegionM;
      const double py = (static_cast<double>(j) + random.uniform()) * kRegionM;
      const double d = std::hypot(px - x, py - y);
      const std::size_t photograph = random.below(photographs_.size());
      if (d < best) {
        best = d;
        chosen = photograph;
      }
    }
  }
  return chosen;
}

Patch PhotographedFloor::patch_of(std::int64_t cell_x, std::int64_t cell_y) const {
  Random random(cell_seed(setup_.seed, cell_x, cell_y));
  Patch patch;
  patch.photograph =
      photograph_at((static_cast<double>(cell_x) + 0.5) * kPatchM, (static_cast<double>(cell_y) + 0.5) * kPatchM);
  const cv::Mat& picture = photographs_[patch.photograph].grey;
  // The turned patch fits in where the picture is large enough; in a small one its rim is mirrored.
  const double reach = kPatchSide * std::numbers::sqrt2 / 2.0;
  const auto place = [&](int size) {
    const double margin = std::min(reach, size / 2.0 - 1.0);
    return random.uniform(margin, size - margin);
  };
  patch.centre_x = place(picture.cols);
  patch.centre_y = place(picture.rows);
  patch.angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  return patch;
}

void PhotographedFloor::add(const Patch& patch, std::int64_t cell_x, std::int64_t cell_y, TileKey key, cv::Mat& sum,
                            cv::Mat& weights) const {
  // The patch's rectangle in texels of the tile; it reaches half a feather over its cell.
  const auto low_texel = [](std::int64_t cell, std::int32_t tile) {
    return static_cast<int>(
        std::lround((static_cast<double>(cell) * kPatchM - kFeatherM / 2 - tile * kTileM) / kTexelM));
  };
  const cv::Rect whole(low_texel(cell_x, key.x), low_texel(cell_y, key.y), kPatchSide, kPatchSide);
  const cv::Rect part = whole & cv::Rect(0, 0, kTileTexels, kTileTexels);
  if (part.empty()) {
    return;
  }
  const double c = std::cos(patch.angle);
  const double s = std::sin(patch.angle);
  const double dx = part.x - whole.x - kPatchSide / 2.0;
  const double dy = part.y - whole.y - kPatchSide / 2.0;
  const cv::Matx23d picture_from_part(c, -s, patch.centre_x + c * dx - s * dy, s, c,
                                      patch.centre_y + s * dx + c * dy);
  cv::Mat crop;
  cv::warpAffine(photographs_[patch.photograph].grey, crop, picture_from_part, part.size(),
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REFLECT_101);
  const float mean = means_[patch.photograph];
  for (int j = 0; j < part.height; ++j) {
    const std::uint8_t* from = crop.ptr<std::uint8_t>(j);
    const float across = ramp_[static_cast<std::size_t>(part.y - whole.y + j)];
    const float* along = ramp_.data() + (part.x - whole.x);
    float* to = sum.ptr<float>(part.y + j) + part.x;
    float* weight = weights.ptr<float>(part.y + j) + part.x;
    for (int i = 0; i < part.width; ++i) {
      const float w = across * along[i];
      to[i] += w * (static_cast<float>(from[i]) - mean);
      weight[i] += w * w;
    }
  }
}

void PhotographedFloor::fill(TileKey key, std::span<std::uint8_t> texels) const {
  cv::Mat sum(kTileTexels, kTileTexels, CV_32F, cv::Scalar(0.0));
  cv::Mat weights(kTileTexels, kTileTexels, CV_32F, cv::Scalar(0.0));
  const auto cell = [](double metres) { return static_cast<std::int64_t>(std::floor(metres / kPatchM)); };
  for (std::int64_t y = cell(key.y * kTileM - kFeatherM); y <= cell((key.y + 1) * kTileM + kFeatherM); ++y) {
    for (std::int64_t x = cell(key.x * kTileM - kFeatherM); x <= cell((key.x + 1) * kTileM + kFeatherM); ++x) {
      add(patch_of(x, y), x, y, key, sum, weights);
    }
  }
  const auto mean = static_cast<float>(setup_.brightness + 0.5);
  const auto contrast = static_cast<float>(setup_.contrast);
  for (int j = 0; j < kTileTexels; ++j) {
    const float* s = sum.ptr<float>(j);
    const float* w = weights.ptr<float>(j);
    std::uint8_t* out = texels.data() + static_cast<std::ptrdiff_t>(j) * kTileTexels;
    for (int i = 0; i < kTileTexels; ++i) {
      // Divided by the root of the squares, a blend keeps its contrast (Heitz & Neyret 2018, eq. 3).
      const float grey = s[i] / std::sqrt(std::max(1e-4F, w[i]));
      out[i] = static_cast<std::uint8_t>(std::clamp(mean + contrast * grey, 0.0F, 255.0F));
    }
  }
}

}  // namespace

Result<std::shared_ptr<const FloorSource>> make_photographed_floor(
    const FloorSetup& setup, const std::string& folder, const std::function<void(const std::string&)>& warn,
    double light_warmth) {
  auto photographs = read_photographs(folder, setup.photograph, light_warmth, warn);
  if (!photographs) {
    return fail(photographs.error());
  }
  return std::shared_ptr<const FloorSource>(std::make_shared<PhotographedFloor>(setup, std::move(*photographs)));
}

}  // namespace weft::agents::sim
