#include "agents/perception/stereo/pair_light.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace weft::agents {
namespace {

/// Holds the grey levels that a twentieth of the pixels is darker than, and brighter than.
struct Greys {
  double dark = 0.0;
  double bright = 0.0;

  double range() const { return bright - dark; }
};

Greys greys_of(const Image& image) {
  std::array<std::size_t, 256> count{};
  std::size_t all = 0;
  for (int row = 0; row < image.height; row += 4) {
    const std::uint8_t* const pixels =
        image.pixels->data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width);
    for (int column = 0; column < image.width; column += 4, ++all) ++count[pixels[column]];
  }
  const std::size_t twentieth = all / 20;
  std::size_t below = 0;
  Greys greys;
  for (std::size_t grey = 0; grey < count.size(); ++grey) {
    if (below <= twentieth) greys.dark = static_cast<double>(grey);
    if (below < all - twentieth) greys.bright = static_cast<double>(grey);
    below += count[grey];
  }
  return greys;
}

}  // namespace

std::optional<Unseen> too_little_light(const PairLightBounds& bounds, const StereoPair& pair) {
  const Greys left = greys_of(pair.left);
  const Greys right = greys_of(pair.right);
  const double brighter = std::max(left.bright, right.bright);
  const double darker = std::min(left.bright, right.bright);
  if (brighter < bounds.least_light) return Unseen{"too_dark", brighter, bounds.least_light};
  if (darker < bounds.least_light) return Unseen{"covered", darker, bounds.least_light};
  const double more = std::max(left.range(), right.range());
  const double less = std::min(left.range(), right.range());
  if (less < bounds.least_likeness * more) return Unseen{"covered", less / more, bounds.least_likeness};
  return std::nullopt;
}

}  // namespace weft::agents
