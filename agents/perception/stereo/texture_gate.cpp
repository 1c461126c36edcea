#include "agents/perception/stereo/texture_gate.hpp"

#include <algorithm>
#include <cstddef>

namespace weft::agents {
namespace {

// The blur and Sobel's kernel are one: 1 3 4 3 1 down, -1 -1 0 1 1 across, of nine times the blurred grey levels.
constexpr double kBlurred = 9.0;
constexpr int kShift = 4;  // squares are kept over 16: 121 of them fit into 32 bits
constexpr int kMargin = 2;

}  // namespace

TextureGate::TextureGate(int width, int height, double least_rms)
    : width_(width),
      height_(height),
      least_(kBlurred * kBlurred * least_rms * least_rms / (1 << kShift)),
      vertical_(static_cast<std::size_t>(width + 2 * kMargin)),
      squares_(static_cast<std::size_t>(kWindow * width)),
      columns_(static_cast<std::size_t>(width)),
      sums_(static_cast<std::size_t>(width + 1)),
      is_textured_(static_cast<std::size_t>(width)) {}

void TextureGate::take(const FiveRows& rows) {
  const std::uint8_t *const a = rows.row[0] - kMargin, *const b = rows.row[1] - kMargin,
                            *const c = rows.row[2] - kMargin, *const d = rows.row[3] - kMargin,
                            *const e = rows.row[4] - kMargin;
  std::int32_t* __restrict const vertical = vertical_.data();
  for (int x = 0; x < width_ + 2 * kMargin; ++x) vertical[x] = a[x] + e[x] + 3 * (b[x] + d[x]) + 4 * c[x];
  std::uint32_t* __restrict const squares = squares_.data() + (taken_ % kWindow) * width_;
  std::uint32_t* __restrict const columns = columns_.data();
  for (int x = 0; x < width_; ++x) {
    const std::int32_t gradient = vertical[x + 3] + vertical[x + 4] - vertical[x] - vertical[x + 1];
    const std::uint32_t square = static_cast<std::uint32_t>(gradient * gradient) >> kShift;
    columns[x] += square - squares[x];  // what was there is of the row that leaves the window
    squares[x] = square;
  }
  ++taken_;
}

const std::uint8_t* TextureGate::told() {
  constexpr int half = kWindow / 2;
  if (told_ == height_ || (taken_ < height_ && taken_ <= told_ + half)) return nullptr;
  // At the lower rim rows leave and none comes in.
  const int leaves = told_ - half - 1;
  if (leaves >= 0 && told_ + half >= height_) {
    std::uint32_t* const squares = squares_.data() + (leaves % kWindow) * width_;
    for (int x = 0; x < width_; ++x) columns_[static_cast<std::size_t>(x)] -= squares[x];
    std::fill(squares, squares + width_, 0U);
  }
  close_row();
  ++told_;
  return is_textured_.data();
}

void TextureGate::close_row() {
  constexpr int half = kWindow / 2;
  const int rows = std::min(told_ + half, height_ - 1) - std::max(told_ - half, 0) + 1;
  std::uint32_t* const sums = sums_.data();
  for (int x = 0; x < width_; ++x) sums[x + 1] = sums[x] + columns_[static_cast<std::size_t>(x)];
  for (int x = 0; x < width_; ++x) {
    const int first = std::max(x - half, 0);
    const int end = std::min(x + half + 1, width_);
    const double bound = least_ * rows * (end - first);
    is_textured_[static_cast<std::size_t>(x)] = static_cast<double>(sums[end] - sums[first]) >= bound ? 1 : 0;
  }
}

}  // namespace weft::agents
