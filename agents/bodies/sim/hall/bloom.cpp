#include "agents/bodies/sim/hall/bloom.hpp"

#include <algorithm>
#include <array>

#include "agents/bodies/sim/hall/quad_scene.hpp"

namespace weft::agents::sim {
namespace {

/// Describes a halo: a box of 2 reach + 1 blocks, three times over, is nearly a Gaussian of sqrt(reach (reach + 1))
/// blocks; and its share of what scatters.
struct Halo {
  std::size_t reach;
  float share;
};
constexpr std::array<Halo, 3> kHalos = {{{1, 0.6F}, {5, 0.3F}, {15, 0.1F}}};
constexpr std::size_t kSide = 4;  // pixels of a block

}  // namespace

Bloom::Bloom(std::size_t columns, std::size_t rows, double share)
    : columns_(columns),
      rows_(rows),
      share_(static_cast<float>(share)),
      blocks_(columns * rows),
      halo_(columns * rows),
      line_(std::max(columns, rows)) {}

/// Averages `count` values that lie `step` apart over 2 reach + 1 of them, line by line; the last ones go on outside.
void Bloom::blur_once(std::size_t reach, std::size_t count, std::size_t lines, std::size_t step,
                      std::size_t line_step) {
  const float per = 1.0F / static_cast<float>(2 * reach + 1);
  for (std::size_t l = 0; l < lines; ++l) {
    float* const values = blocks_.data() + l * line_step;
    for (std::size_t i = 0; i < count; ++i) line_[i] = values[i * step];
    const auto at = [&](std::size_t i) { return line_[i < reach ? 0 : std::min(i - reach, count - 1)]; };
    float sum = 0.0F;
    for (std::size_t i = 0; i < 2 * reach + 1; ++i) sum += at(i);
    for (std::size_t i = 0; i < count; ++i) {
      values[i * step] = sum * per;
      sum += at(i + 2 * reach + 1) - at(i);
    }
  }
}

void Bloom::blur(std::size_t reach) {
  for (int times = 0; times < 3; ++times) {
    blur_once(reach, columns_, rows_, 1, columns_);
    blur_once(reach, rows_, columns_, columns_, 1);
  }
}

void Bloom::scatter(std::vector<float>& light) {
  if (share_ <= 0.0F) return;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    float sum = 0.0F;
    for (std::size_t i = 0; i < kRays; ++i) sum += light[block * kRays + i];
    blocks_[block] = sum / kRays;
  }
  std::fill(halo_.begin(), halo_.end(), 0.0F);
  const std::vector<float> sharp = blocks_;
  for (const Halo& halo : kHalos) {
    blocks_ = sharp;
    blur(halo.reach);
    for (std::size_t i = 0; i < halo_.size(); ++i) halo_[i] += halo.share * blocks_[i];
  }
  add_halos(light);
}

/// Adds the halos to each pixel, in proportion to how near the blocks about it are.
void Bloom::add_halos(std::vector<float>& light) const {
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::size_t block = row * columns_ + column;
      const std::size_t left = column > 0 ? block - 1 : block;
      const std::size_t right = column + 1 < columns_ ? block + 1 : block;
      const std::size_t up = row > 0 ? columns_ : 0;
      const std::size_t down = row + 1 < rows_ ? columns_ : 0;
      for (std::size_t i = 0; i < kRays; ++i) {
        const std::size_t ray_row = i / kSide;
        const float right_px = (static_cast<float>(i % kSide) - 1.5F) / kSide;
        const float down_px = (static_cast<float>(ray_row) - 1.5F) / kSide;
        const float share_x = right_px < 0.0F ? -right_px : right_px;
        const float share_y = down_px < 0.0F ? -down_px : down_px;
        const std::size_t beside = right_px < 0.0F ? left : right;
        const auto other_row = [&](std::size_t at) { return down_px < 0.0F ? at - up : at + down; };
        const float near = halo_[block] + share_x * (halo_[beside] - halo_[block]);
        const float far = halo_[other_row(block)] + share_x * (halo_[other_row(beside)] - halo_[other_row(block)]);
        float& pixel = light[block * kRays + i];
        pixel += share_ * (near + share_y * (far - near) - pixel);
      }
    }
  }
}

}  // namespace weft::agents::sim
