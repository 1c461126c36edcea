#include "agents/bodies/sim/floor/procedural.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "agents/bodies/sim/floor/kernels.hpp"
#include "agents/bodies/sim/floor/layer.hpp"
#include "agents/bodies/sim/floor/planks.hpp"
#include "agents/bodies/sim/floor/scatter.hpp"
#include "agents/bodies/sim/floor/tile_print.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr int kTop = 10;  // the lattice with one cell a tile
constexpr int kPad = 2;   // cells around a tile that its finer lattices look at
constexpr int kWidth = kTileTexels + 2 * kPad;
constexpr int kBroadLevel = 3;       // stains, scuffs and tyre marks are drawn on this lattice, 5 mm a cell
constexpr double kTyreReachM = 1.5;  // of a tyre mark from its middle

enum Stream : std::uint64_t { chips = 1, stains, cracks, scuffs, tyres, fissures = 9 };

class ProceduralFloor final : public FloorSource {
 public:
  ProceduralFloor(const FloorSetup& setup, const Material& material, double light_warmth)
      : setup_(setup), material_(material), light_warmth_(static_cast<float>(light_warmth)) {
    if (material.pieces == Material::Pieces::tiles) print_.emplace(setup.seed);
  }

  void fill(TileKey key, std::span<std::uint8_t> texels) const override;
  double gloss() const override { return material_.gloss * setup_.gloss; }

 private:
  std::vector<float> lattice(TileKey key, Channel channel) const;
  std::vector<float> drawn(TileKey key, Channel channel) const;
  float amplitude(int level, Channel channel) const;
  void draw_broad(TileKey key, const Layer& layer) const;
  void draw_tyre(Random& random, double x, double y, const Layer& layer) const;
  void draw_fissure(Random& random, double x, double y, const Layer& layer) const;
  void draw_fine(TileKey key, const Layer& layer) const;
  void draw_joints(const Layer& layer) const;
  void draw_walk(Random& random, double x, double y, const Stroke& pen, double bend, const Layer& layer) const;
  double warmth(Random& random) const { return random.uniform(-1.0, 1.0) * material_.warmth_spread; }

  FloorSetup setup_;
  Material material_;
  float light_warmth_ = 0.0F;
  std::optional<TilePrint> print_;
};

/// Returns the noise of a level: colours differ from decimetre to decimetre; from grain to grain by the chips.
float ProceduralFloor::amplitude(int level, Channel channel) const {
  if (channel == Channel::grey) return material_.octaves[static_cast<std::size_t>(level)];
  return level >= 5 ? static_cast<float>(0.12 * material_.warmth_spread) : 0.0F;
}

/// Makes the lattices of a tile from one cell a tile down to one a texel: each is the coarser one, doubled smoothly,
/// plus noise of its own.
std::vector<float> ProceduralFloor::lattice(TileKey key, Channel channel) const {
  std::vector<float> coarse;
  std::vector<float> fine;
  for (int level = kTop; level >= 0; --level) {
    const int n = kTileTexels >> level;
    const int width = n + 2 * kPad;
    fine.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(width), 0.0F);
    const int coarse_width = n / 2 + 2 * kPad;
    for (int j = -kPad; j < n + kPad; ++j) {
      float* row = fine.data() + static_cast<std::ptrdiff_t>(j + kPad) * width;
      if (level < kTop) {
        const int near = (j >> 1) + kPad;
        const int far = (j & 1) == 0 ? near - 1 : near + 1;
        kernels().double_row(coarse.data() + static_cast<std::ptrdiff_t>(near) * coarse_width,
                             coarse.data() + static_cast<std::ptrdiff_t>(far) * coarse_width, width, row);
      }
      const auto seed =
          static_cast<std::uint32_t>(setup_.seed * 0x9E3779B1U + static_cast<unsigned>(level) * 0x632BE5ABU +
                                     static_cast<unsigned>(channel) * 0x2545F491U);
      kernels().add_noise_row(key.x * n - kPad, key.y * n + j, seed, width, amplitude(level, channel), row);
    }
    if (level == kBroadLevel) {
      draw_broad(key,
                 {channel, Canvas{fine, width, kTexelM * (1 << level), key.x * kTileM - kPad * kTexelM * (1 << level),
                                  key.y * kTileM - kPad * kTexelM * (1 << level)}});
    }
    std::swap(coarse, fine);
  }
  return coarse;
}

void ProceduralFloor::draw_walk(Random& random, double x, double y, const Stroke& pen, double bend,
                                const Layer& layer) const {
  constexpr double kStepM = 0.025;
  double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
  double turn = 0.0;
  const int steps = 12 + static_cast<int>(random.below(36));  // at most 1.2 m
  for (int i = 0; i < steps; ++i) {
    turn = 0.8 * turn + random.normal(0.0, bend);
    heading += turn;
    Stroke stroke = pen;
    stroke.x0 = x;
    stroke.y0 = y;
    x += kStepM * std::cos(heading);
    y += kStepM * std::sin(heading);
    stroke.x1 = x;
    stroke.y1 = y;
    layer.draw(stroke, 0.0);
  }
}

void ProceduralFloor::draw_broad(TileKey key, const Layer& layer) const {
  scatter(setup_.seed, stains, material_.stains_per_m2, kTileM, 0.5, key, [&](Random& random, double x, double y) {
    const double size = random.uniform(0.02, 0.18);
    const Ellipse stain{x,
                        y,
                        size,
                        size * random.uniform(0.4, 1.0),
                        random.uniform(0.0, 3.14),
                        size * 0.6,
                        random.uniform(-1.0, 0.5) * material_.stain_grey};
    layer.draw(stain, warmth(random));
  });
  scatter(setup_.seed, scuffs, material_.scuffs_per_m2, 2 * kTileM, 1.3, key,
          [&](Random& random, double x, double y) {
            const Stroke pen{
                .half_width_m = random.uniform(0.004, 0.03), .soft_m = 0.02, .grey = random.uniform(-5.0, 1.5)};
            draw_walk(random, x, y, pen, 0.01, layer);
          });
  scatter(setup_.seed, tyres, material_.tyres_per_m2, 4 * kTileM, kTyreReachM, key,
          [&](Random& random, double x, double y) { draw_tyre(random, x, y, layer); });
}

/// Draws rubber that a turning or braking wheel leaves: a few ribs side by side along a bend, fading in and out.
void ProceduralFloor::draw_tyre(Random& random, double x, double y, const Layer& layer) const {
  const double radius = random.uniform(1.2, 6.0);
  const double middle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double length = random.uniform(0.6, 2.0 * (kTyreReachM - 0.2));
  const double half_width = random.uniform(0.02, 0.055);
  const double grey = random.uniform(-20.0, -5.0);
  Arc arc{.x = x - radius * std::cos(middle),
          .y = y - radius * std::sin(middle),
          .radius_m = radius,
          .middle = middle,
          .half_angle = std::min(1.2, 0.5 * length / radius),
          .half_width_m = half_width,
          .soft_m = 0.012,
          .fade_m = 0.25,
          .grey = 0.6 * grey};
  layer.draw(arc, 0.0);
  const int ribs = 2 + static_cast<int>(random.below(3));
  for (int i = 0; i < ribs; ++i) {
    arc.radius_m = radius + half_width * (2.0 * (i + 0.5) / ribs - 1.0);
    arc.half_width_m = 0.55 * half_width / ribs;
    arc.soft_m = 0.006;
    arc.grey = random.uniform(0.2, 1.1) * grey;
    layer.draw(arc, 0.0);
  }
}

/// Draws a fissure from its middle both ways, jagged, getting finer; here and there a fine crack leaves it.
void ProceduralFloor::draw_fissure(Random& random, double x, double y, const Layer& layer) const {
  constexpr double kStepM = 0.02;
  const double along = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double width = random.uniform(0.0008, 0.0016);
  const double grey = random.uniform(-65.0, -40.0);
  const int steps = 20 + static_cast<int>(random.below(50));  // at most 1.4 m a side
  for (const double way : {0.0, std::numbers::pi}) {
    Stroke stroke{.x1 = x, .y1 = y, .soft_m = 0.0008, .grey = grey};
    double heading = along + way;
    for (int i = 0; i < steps; ++i) {
      heading += random.normal(0.0, 0.06);
      const double jag = heading + random.normal(0.0, 0.45);
      stroke.x0 = stroke.x1;
      stroke.y0 = stroke.y1;
      stroke.x1 += kStepM * std::cos(jag);
      stroke.y1 += kStepM * std::sin(jag);
      stroke.half_width_m = width * (1.0 - 0.8 * i / steps);
      layer.draw(stroke, 0.0);
      if (random.chance(0.04)) {
        draw_walk(random, stroke.x1, stroke.y1, {.half_width_m = 0.3 * width, .soft_m = 0.0008, .grey = 0.7 * grey},
                  0.15, layer);
      }
    }
  }
}

void ProceduralFloor::draw_fine(TileKey key, const Layer& layer) const {
  const Material& m = material_;
  scatter(setup_.seed, chips, m.chips_per_m2, kTileM / 8, m.chip_most_m * 1.6, key,
          [&](Random& random, double x, double y) {
            // Many small ones, few big ones.
            const double u = random.uniform();
            const double a = m.chip_least_m + (m.chip_most_m - m.chip_least_m) * u * u * u;
            const double b = a * random.uniform(0.5, 1.0);
            const double angle = random.uniform(0.0, 3.14);
            const Ellipse chip{x, y, a, b, angle, 0.4 * b, random.uniform(-m.chip_dark, m.chip_light)};
            layer.draw(chip, warmth(random));
          });
  scatter(setup_.seed, cracks, m.cracks_per_m2, 2 * kTileM, 1.3, key, [&](Random& random, double x, double y) {
    const Stroke pen{
        .half_width_m = random.uniform(0.0003, 0.0009), .soft_m = 0.0008, .grey = random.uniform(-55.0, -25.0)};
    draw_walk(random, x, y, pen, 0.12, layer);
  });
  scatter(setup_.seed, fissures, m.fissures_per_m2, 4 * kTileM, 2.7, key,
          [&](Random& random, double x, double y) { draw_fissure(random, x, y, layer); });
  if (m.joint_spacing_m > 0.0) draw_joints(layer);
}

void ProceduralFloor::draw_joints(const Layer& layer) const {
  constexpr double kFirstM = 1.37;
  const Canvas& canvas = layer.canvas;
  const double spacing = material_.joint_spacing_m;
  const double side = canvas.side * canvas.texel_m;
  const auto next = [&](double from) { return kFirstM + std::ceil((from - 0.01 - kFirstM) / spacing) * spacing; };
  const Stroke cut{.half_width_m = 0.0018, .soft_m = 0.001, .grey = -50.0};
  for (double x = next(canvas.x0_m); x < canvas.x0_m + side + 0.01; x += spacing) {
    Stroke stroke = cut;
    stroke.x0 = stroke.x1 = x;
    stroke.y0 = canvas.y0_m - 0.1;
    stroke.y1 = canvas.y0_m + side + 0.1;
    layer.draw(stroke, 0.0);
  }
  for (double y = next(canvas.y0_m); y < canvas.y0_m + side + 0.01; y += spacing) {
    Stroke stroke = cut;
    stroke.y0 = stroke.y1 = y;
    stroke.x0 = canvas.x0_m - 0.1;
    stroke.x1 = canvas.x0_m + side + 0.1;
    layer.draw(stroke, 0.0);
  }
}

std::vector<float> ProceduralFloor::drawn(TileKey key, Channel channel) const {
  std::vector<float> values = lattice(key, channel);
  const Layer layer{
      channel, Canvas{values, kWidth, kTexelM, key.x * kTileM - kPad * kTexelM, key.y * kTileM - kPad * kTexelM}};
  if (print_) print_->add(layer);
  if (material_.pieces == Material::Pieces::planks) add_planks(setup_.seed, layer);
  draw_fine(key, layer);
  return values;
}

void ProceduralFloor::fill(TileKey key, std::span<std::uint8_t> texels) const {
  const std::vector<float> grey = drawn(key, Channel::grey);
  const bool coloured = light_warmth_ != 0.0F;
  const std::vector<float> warmth = coloured ? drawn(key, Channel::warmth) : std::vector<float>(grey.size());
  const auto mean = static_cast<float>(setup_.brightness + 0.5);
  const auto contrast = static_cast<float>(setup_.contrast);
  const auto mean_warmth = static_cast<float>(material_.warmth);
  for (int j = 0; j < kTileTexels; ++j) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(j + kPad) * kWidth + kPad;
    const float* const row = grey.data() + from;
    std::uint8_t* const out = texels.data() + static_cast<std::ptrdiff_t>(j) * kTileTexels;
    if (!coloured) {
      for (int i = 0; i < kTileTexels; ++i) {
        out[i] = static_cast<std::uint8_t>(std::clamp(mean + contrast * row[i], 0.0F, 255.0F));
      }
      continue;
    }
    const float* const warm = warmth.data() + from;
    for (int i = 0; i < kTileTexels; ++i) {
      const float seen = 1.0F + light_warmth_ * std::clamp(mean_warmth + warm[i], -1.0F, 1.0F);
      out[i] = static_cast<std::uint8_t>(std::clamp((mean + contrast * row[i]) * seen, 0.0F, 255.0F));
    }
  }
}

}  // namespace

Result<std::shared_ptr<const FloorSource>> make_procedural_floor(const FloorSetup& setup, double light_warmth) {
  std::string names;
  for (const Material& material : materials()) {
    if (material.name == setup.material) {
      return std::shared_ptr<const FloorSource>(std::make_shared<ProceduralFloor>(setup, material, light_warmth));
    }
    names += (names.empty() ? "" : ", ") + material.name;
  }
  return fail(ErrorCode::not_found, "floor.material: no \"" + setup.material + "\"; there are " + names);
}

}  // namespace weft::agents::sim
