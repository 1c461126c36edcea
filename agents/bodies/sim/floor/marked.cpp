#include "agents/bodies/sim/floor/marked.hpp"

#include <algorithm>
#include <vector>

#include "agents/bodies/sim/floor/scatter.hpp"
#include "agents/bodies/sim/floor/stamp.hpp"

namespace weft::agents::sim {
namespace {

constexpr std::uint64_t kDirtStream = 7;
constexpr double kPaintCovers = 0.85;  // of the floor's own look; the rest shows through

class MarkedFloor final : public FloorSource {
 public:
  MarkedFloor(std::shared_ptr<const FloorSource> floor, const Change& change)
      : floor_(std::move(floor)), change_(change) {}

  void fill(TileKey key, std::span<std::uint8_t> texels) const override;
  double gloss() const override { return floor_->gloss(); }

 private:
  std::shared_ptr<const FloorSource> floor_;
  Change change_;
};

bool is_near(const PaintedLine& line, TileKey key) {
  const double rim = line.width_m;
  return std::max(line.x0, line.x1) + rim >= key.x * kTileM &&
         std::min(line.x0, line.x1) - rim <= (key.x + 1) * kTileM &&
         std::max(line.y0, line.y1) + rim >= key.y * kTileM &&
         std::min(line.y0, line.y1) - rim <= (key.y + 1) * kTileM;
}

/// Changes every texel by what its value on the canvas says.
template <class Become>
void blend(const std::vector<float>& amounts, std::span<std::uint8_t> texels, Become&& become) {
  for (std::size_t i = 0; i < texels.size(); ++i) {
    texels[i] =
        static_cast<std::uint8_t>(std::clamp(become(static_cast<float>(texels[i]), amounts[i]) + 0.5F, 0.0F, 255.0F));
  }
}

void MarkedFloor::fill(TileKey key, std::span<std::uint8_t> texels) const {
  floor_->fill(key, texels);
  std::vector<float> amounts(texels.size());
  const Canvas canvas{amounts, kTileTexels, kTexelM, key.x * kTileM, key.y * kTileM};
  for (const PaintedLine& line : change_.lines) {
    if (!is_near(line, key)) continue;
    std::fill(amounts.begin(), amounts.end(), 0.0F);
    stamp(Stroke{line.x0, line.y0, line.x1, line.y1, line.width_m / 2, 0.002, kPaintCovers}, canvas);
    const auto paint = static_cast<float>(line.grey * (1.0 + change_.light_warmth * line.warmth));
    blend(amounts, texels, [&](float under, float cover) { return under + cover * (paint - under); });
  }
  if (change_.dirt_per_m2 > 0.0) {
    std::fill(amounts.begin(), amounts.end(), 0.0F);
    scatter(change_.seed, kDirtStream, change_.dirt_per_m2, kTileM / 8, 0.02, key,
            [&](Random& random, double x, double y) {
              // Crumbs, and among them shreds; few big ones.
              const double u = random.uniform();
              const double a = 0.0008 + 0.010 * u * u * u;
              const double b = a * random.uniform(0.25, 1.0);
              stamp(Ellipse{x, y, a, b, random.uniform(0.0, 3.14), 0.5 * b, random.uniform(-75.0, 40.0)}, canvas);
            });
    blend(amounts, texels, [](float under, float dirt) { return under + dirt; });
  }
}

}  // namespace

std::shared_ptr<const FloorSource> make_marked_floor(std::shared_ptr<const FloorSource> floor, const Change& change) {
  return std::make_shared<MarkedFloor>(std::move(floor), change);
}

}  // namespace weft::agents::sim
