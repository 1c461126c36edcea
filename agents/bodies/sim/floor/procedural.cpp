#include "agents/bodies/sim/floor/procedural.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/bodies/sim/floor/kernels.hpp"
#include "agents/bodies/sim/floor/stamp.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr int kTop = 10;        // the lattice with one cell a tile
constexpr int kPad = 2;         // cells around a tile that its finer lattices look at
constexpr int kBroadLevel = 3;  // stains and scuffs are drawn on this lattice, 5 mm a cell

enum Stream : std::uint64_t { chips = 1, stains, cracks, scuffs };

Random random_of(std::uint64_t seed, Stream stream, std::int64_t x, std::int64_t y) {
  return Random((seed * 8 + stream) * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(x) * 0xC2B2AE3D27D4EB4FULL ^
                static_cast<std::uint64_t>(y) * 0x165667B19E3779F9ULL);
}

/// How many things of this density a cell holds: the mean, rounded by chance.
int count_of(double per_m2, double cell_m, Random& random) {
  return static_cast<int>(std::floor(per_m2 * cell_m * cell_m + random.uniform()));
}

/// Calls `draw(random, x, y)` for each thing whose cell lies within `reach_m` of the tile.
template <class Draw>
void scatter(std::uint64_t seed, Stream stream, double per_m2, double cell_m, double reach_m, TileKey key,
             Draw&& draw) {
  if (per_m2 <= 0.0) {
    return;
  }
  const auto first = [&](int tile) {
    return static_cast<std::int64_t>(std::floor((tile * kTileM - reach_m) / cell_m));
  };
  const auto last = [&](int tile) {
    return static_cast<std::int64_t>(std::floor(((tile + 1) * kTileM + reach_m) / cell_m));
  };
  for (std::int64_t j = first(key.y); j <= last(key.y); ++j) {
    for (std::int64_t i = first(key.x); i <= last(key.x); ++i) {
      Random random = random_of(seed, stream, i, j);
      for (int n = count_of(per_m2, cell_m, random); n > 0; --n) {
        const double x = (static_cast<double>(i) + random.uniform()) * cell_m;
        const double y = (static_cast<double>(j) + random.uniform()) * cell_m;
        Random own = random.fork(static_cast<std::uint64_t>(n));
        draw(own, x, y);
      }
    }
  }
}

class ProceduralFloor final : public FloorSource {
 public:
  ProceduralFloor(const FloorSetup& setup, const Material& material) : setup_(setup), material_(material) {}

  void fill(TileKey key, std::span<std::uint8_t> texels) const override;
  double gloss() const override { return material_.gloss * setup_.gloss; }

 private:
  std::vector<float> lattice(TileKey key) const;
  void draw_broad(TileKey key, const Canvas& canvas) const;
  void draw_fine(TileKey key, const Canvas& canvas) const;
  void draw_walk(Random& random, double x, double y, const Stroke& pen, double bend, const Canvas& canvas) const;

  FloorSetup setup_;
  Material material_;
};

/// From one cell a tile down to one a texel: each lattice is the coarser one, doubled smoothly, plus noise of its
/// own.
std::vector<float> ProceduralFloor::lattice(TileKey key) const {
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
          static_cast<std::uint32_t>(setup_.seed * 0x9E3779B1U + static_cast<unsigned>(level) * 0x632BE5ABU);
      kernels().add_noise_row(key.x * n - kPad, key.y * n + j, seed, width,
                              material_.octaves[static_cast<std::size_t>(level)], row);
    }
    if (level == kBroadLevel) {
      draw_broad(key, Canvas{fine, width, kTexelM * (1 << level), key.x * kTileM - kPad * kTexelM * (1 << level),
                             key.y * kTileM - kPad * kTexelM * (1 << level)});
    }
    std::swap(coarse, fine);
  }
  return coarse;
}

void ProceduralFloor::draw_walk(Random& random, double x, double y, const Stroke& pen, double bend,
                                const Canvas& canvas) const {
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
    stamp(stroke, canvas);
  }
}

void ProceduralFloor::draw_broad(TileKey key, const Canvas& canvas) const {
  scatter(setup_.seed, stains, material_.stains_per_m2, kTileM, 0.5, key, [&](Random& random, double x, double y) {
    const double size = random.uniform(0.02, 0.18);
    stamp(Ellipse{x, y, size, size * random.uniform(0.4, 1.0), random.uniform(0.0, 3.14), size * 0.6,
                  random.uniform(-1.0, 0.5) * material_.stain_grey},
          canvas);
  });
  scatter(setup_.seed, scuffs, material_.scuffs_per_m2, 2 * kTileM, 1.3, key,
          [&](Random& random, double x, double y) {
            const Stroke pen{
                .half_width_m = random.uniform(0.004, 0.03), .soft_m = 0.02, .grey = random.uniform(-5.0, 1.5)};
            draw_walk(random, x, y, pen, 0.01, canvas);
          });
}

void ProceduralFloor::draw_fine(TileKey key, const Canvas& canvas) const {
  const Material& m = material_;
  scatter(setup_.seed, chips, m.chips_per_m2, kTileM / 8, m.chip_most_m * 1.6, key,
          [&](Random& random, double x, double y) {
            // Many small ones, few big ones.
            const double u = random.uniform();
            const double a = m.chip_least_m + (m.chip_most_m - m.chip_least_m) * u * u * u;
            const double b = a * random.uniform(0.5, 1.0);
            const double angle = random.uniform(0.0, 3.14);
            stamp(Ellipse{x, y, a, b, angle, 0.4 * b, random.uniform(-m.chip_dark, m.chip_light)}, canvas);
          });
  scatter(setup_.seed, cracks, m.cracks_per_m2, 2 * kTileM, 1.3, key, [&](Random& random, double x, double y) {
    const Stroke pen{
        .half_width_m = random.uniform(0.0003, 0.0009), .soft_m = 0.0008, .grey = random.uniform(-55.0, -25.0)};
    draw_walk(random, x, y, pen, 0.12, canvas);
  });
  if (m.joint_spacing_m > 0.0) {
    constexpr double kFirstM = 1.37;
    const double side = canvas.side * canvas.texel_m;
    const auto next = [&](double from) {
      return kFirstM + std::ceil((from - 0.01 - kFirstM) / m.joint_spacing_m) * m.joint_spacing_m;
    };
    const Stroke cut{.half_width_m = 0.0018, .soft_m = 0.001, .grey = -50.0};
    for (double x = next(canvas.x0_m); x < canvas.x0_m + side + 0.01; x += m.joint_spacing_m) {
      Stroke stroke = cut;
      stroke.x0 = stroke.x1 = x;
      stroke.y0 = canvas.y0_m - 0.1;
      stroke.y1 = canvas.y0_m + side + 0.1;
      stamp(stroke, canvas);
    }
    for (double y = next(canvas.y0_m); y < canvas.y0_m + side + 0.01; y += m.joint_spacing_m) {
      Stroke stroke = cut;
      stroke.y0 = stroke.y1 = y;
      stroke.x0 = canvas.x0_m - 0.1;
      stroke.x1 = canvas.x0_m + side + 0.1;
      stamp(stroke, canvas);
    }
  }
}

void ProceduralFloor::fill(TileKey key, std::span<std::uint8_t> texels) const {
  std::vector<float> grey = lattice(key);
  constexpr int kWidth = kTileTexels + 2 * kPad;
  draw_fine(key, Canvas{grey, kWidth, kTexelM, key.x * kTileM - kPad * kTexelM, key.y * kTileM - kPad * kTexelM});
  const auto mean = static_cast<float>(setup_.brightness + 0.5);
  const auto contrast = static_cast<float>(setup_.contrast);
  for (int j = 0; j < kTileTexels; ++j) {
    const float* row = grey.data() + static_cast<std::ptrdiff_t>(j + kPad) * kWidth + kPad;
    std::uint8_t* out = texels.data() + static_cast<std::ptrdiff_t>(j) * kTileTexels;
    for (int i = 0; i < kTileTexels; ++i) {
      out[i] = static_cast<std::uint8_t>(std::clamp(mean + contrast * row[i], 0.0F, 255.0F));
    }
  }
}

}  // namespace

const std::vector<Material>& materials() {
  static const std::vector<Material> all = {
      {.name = "concrete",
       .octaves = {5, 9, 12, 9, 6, 5, 5, 6, 7, 7, 6},
       .chips_per_m2 = 5000,
       .chip_least_m = 0.0005,
       .chip_most_m = 0.006,
       .chip_dark = 45,
       .chip_light = 26,
       .stains_per_m2 = 3,
       .stain_grey = 14,
       .cracks_per_m2 = 0.25,
       .scuffs_per_m2 = 0.8,
       .joint_spacing_m = 4.0,
       .gloss = 22},
      {.name = "polished-concrete",
       .octaves = {2, 3, 4, 4, 3, 3, 4, 6, 8, 9, 8},
       .chips_per_m2 = 2500,
       .chip_least_m = 0.0006,
       .chip_most_m = 0.009,
       .chip_dark = 30,
       .chip_light = 18,
       .stains_per_m2 = 2,
       .stain_grey = 9,
       .cracks_per_m2 = 0.08,
       .scuffs_per_m2 = 0.5,
       .joint_spacing_m = 5.0,
       .gloss = 50},
      {.name = "worn-concrete",
       .octaves = {5, 8, 10, 9, 7, 6, 6, 8, 9, 9, 8},
       .chips_per_m2 = 4000,
       .chip_least_m = 0.0006,
       .chip_most_m = 0.008,
       .chip_dark = 55,
       .chip_light = 26,
       .stains_per_m2 = 6,
       .stain_grey = 22,
       .cracks_per_m2 = 1.6,
       .scuffs_per_m2 = 2.0,
       .joint_spacing_m = 4.0,
       .gloss = 8},
      {.name = "asphalt",
       .octaves = {8, 12, 16, 14, 6, 4, 3, 3, 4, 4, 4},
       .chips_per_m2 = 16000,
       .chip_least_m = 0.0008,
       .chip_most_m = 0.007,
       .chip_dark = 40,
       .chip_light = 60,
       .stains_per_m2 = 1,
       .stain_grey = 12,
       .cracks_per_m2 = 0.5,
       .scuffs_per_m2 = 0.4,
       .gloss = 6},
      {.name = "terrazzo",
       .octaves = {3, 4, 4, 3, 3, 3, 3, 3, 3, 3, 3},
       .chips_per_m2 = 9000,
       .chip_least_m = 0.001,
       .chip_most_m = 0.010,
       .chip_dark = 55,
       .chip_light = 55,
       .stains_per_m2 = 1,
       .stain_grey = 8,
       .scuffs_per_m2 = 0.6,
       .joint_spacing_m = 2.5,
       .gloss = 45},
      {.name = "epoxy",
       .octaves = {2, 3, 4, 4, 3, 3, 3, 4, 4, 4, 4},
       .chips_per_m2 = 900,
       .chip_least_m = 0.0005,
       .chip_most_m = 0.004,
       .chip_dark = 35,
       .chip_light = 25,
       .stains_per_m2 = 4,
       .stain_grey = 10,
       .cracks_per_m2 = 0.05,
       .scuffs_per_m2 = 2.5,
       .gloss = 60},
  };
  return all;
}

Result<std::shared_ptr<const FloorSource>> make_procedural_floor(const FloorSetup& setup) {
  std::string names;
  for (const Material& material : materials()) {
    if (material.name == setup.material) {
      return std::shared_ptr<const FloorSource>(std::make_shared<ProceduralFloor>(setup, material));
    }
    names += (names.empty() ? "" : ", ") + material.name;
  }
  return fail(ErrorCode::not_found, "floor.material: no \"" + setup.material + "\"; there are " + names);
}

}  // namespace weft::agents::sim
