#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "agents/perception/view.hpp"
#include "core/random.hpp"

namespace weft::test {

/// Holds a wall of cards of all sizes and greys, wider than a view: what a camera that turns sees of far things.
class UprightScene {
 public:
  UprightScene(std::uint64_t seed, int width, int height) : width_(width), height_(height), grey_(width * height) {
    Random random(seed);
    for (int card = 0; card < width * height / 300; ++card) paste(random);
  }

  /// Pastes other cards over `share` of the wall: stock that has changed.
  void change(double share, std::uint64_t seed) {
    Random random(seed);
    for (double area = 0.0; area < share * width_ * height_;) area += 0.6 * paste(random);
  }

  /// Returns the view of columns from `left` on, rows from `top` on; grey values times `gain`, with noise of `noise`
  /// grey levels. Throws std::out_of_range when the view reaches beyond the wall.
  agents::Image view(int left, int top, int width, int height, double gain = 1.0, double noise = 2.0,
                     std::uint64_t seed = 1) const {
    if (left < 0 || top < 0 || left + width > width_ || top + height > height_)
      throw std::out_of_range("a view reaches beyond the wall of cards");
    Random random(seed);
    Bytes pixels;
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const double grey =
            gain * grey_[static_cast<std::size_t>((v + top) * width_ + u + left)] + noise * random.normal();
        pixels.push_back(static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0)));
      }
    }
    return {width, height, std::make_shared<const Bytes>(std::move(pixels))};
  }

 private:
  /// Returns its area.
  double paste(Random& random) {
    const int w = 4 + static_cast<int>(random.below(36));
    const int h = 4 + static_cast<int>(random.below(36));
    const int x = static_cast<int>(random.below(static_cast<std::uint64_t>(width_)));
    const int y = static_cast<int>(random.below(static_cast<std::uint64_t>(height_)));
    const auto grey = static_cast<std::uint8_t>(30 + random.below(200));
    for (int v = y; v < std::min(y + h, height_); ++v)
      for (int u = x; u < std::min(x + w, width_); ++u) grey_[static_cast<std::size_t>(v * width_ + u)] = grey;
    return static_cast<double>(w) * h;
  }

  int width_, height_;
  std::vector<std::uint8_t> grey_;
};

}  // namespace weft::test
