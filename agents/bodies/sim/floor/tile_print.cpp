#include "agents/bodies/sim/floor/tile_print.hpp"

#include <cmath>
#include <numbers>

#include "agents/bodies/sim/floor/source.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kSideM = kPrintTexels * kTexelM;
constexpr double kJointM = 0.0015;  // half of it: 3 mm between two tiles
constexpr double kJointGrey = -38.0;

Layer layer_on(std::vector<float>& values, Channel channel) {
  return {channel, Canvas{values, kPrintTexels, kTexelM, 0.0, 0.0}};
}

/// Draws clouds, veins and specks, as a printer puts them on stoneware.
void draw_print(Random random, const Layer& layer) {
  for (int i = 0; i < 60; ++i) {
    const double size = random.uniform(0.01, 0.06);
    const Ellipse cloud{random.uniform(0.0, kSideM),     random.uniform(0.0, kSideM), size,
                        size * random.uniform(0.3, 0.8), random.uniform(0.0, 3.14),   size * 0.8,
                        random.uniform(-11.0, 11.0)};
    layer.draw(cloud, random.uniform(-0.04, 0.06));
  }
  for (int i = 0; i < 9; ++i) {
    double x = random.uniform(0.0, kSideM);
    double y = random.uniform(0.0, kSideM);
    double heading = random.uniform(0.4, 1.1);
    const double half_width = random.uniform(0.0004, 0.0018);
    const double grey = random.uniform(-20.0, 16.0);
    for (int n = 0; n < 30; ++n) {
      heading += random.normal(0.0, 0.2);
      const double x1 = x + 0.008 * std::cos(heading);
      const double y1 = y + 0.008 * std::sin(heading);
      layer.draw(Stroke{x, y, x1, y1, half_width, 0.0015, grey}, 0.1);
      x = x1;
      y = y1;
    }
  }
  for (int i = 0; i < 900; ++i) {
    const double size = random.uniform(0.0005, 0.0022);
    layer.draw(Ellipse{random.uniform(0.0, kSideM), random.uniform(0.0, kSideM), size, 0.8 * size,
                       random.uniform(0.0, 3.14), 0.4 * size, random.uniform(-26.0, 18.0)},
               random.uniform(-0.1, 0.2));
  }
}

void draw_joint(const Layer& layer) {
  for (int j = 0; j < kPrintTexels; ++j) {
    for (int i = 0; i < kPrintTexels; ++i) {
      const int rim = std::min(std::min(i, kPrintTexels - 1 - i), std::min(j, kPrintTexels - 1 - j));
      const double share = 0.5 + (kJointM - (rim + 0.5) * kTexelM) / kTexelM;
      if (share <= 0.0) continue;
      float& value = layer.canvas.values[static_cast<std::size_t>(j * kPrintTexels + i)];
      const double joint = layer.channel == Channel::grey ? kJointGrey : 0.0;
      value = static_cast<float>(value + std::min(1.0, share) * (joint - static_cast<double>(value)));
    }
  }
}

}  // namespace

TilePrint::TilePrint(std::uint64_t seed)
    : grey_(static_cast<std::size_t>(kPrintTexels) * kPrintTexels), warmth_(grey_.size()) {
  const Random random(seed * 0x9E3779B97F4A7C15ULL + 11);
  for (const Channel channel : {Channel::grey, Channel::warmth}) {
    const Layer layer = layer_on(channel == Channel::grey ? grey_ : warmth_, channel);
    draw_print(random, layer);
    draw_joint(layer);
  }
}

void TilePrint::add(const Layer& layer) const {
  const std::vector<float>& print = layer.channel == Channel::grey ? grey_ : warmth_;
  const Canvas& canvas = layer.canvas;
  const auto within = [](long texel) {
    return static_cast<int>((texel % kPrintTexels + kPrintTexels) % kPrintTexels);
  };
  const int x0 = within(std::lround(canvas.x0_m / kTexelM));
  const int y0 = within(std::lround(canvas.y0_m / kTexelM));
  for (int j = 0; j < canvas.side; ++j) {
    const float* const from = print.data() + static_cast<std::ptrdiff_t>(within(y0 + j)) * kPrintTexels;
    float* const to = canvas.values.data() + static_cast<std::ptrdiff_t>(j) * canvas.side;
    for (int i = 0, x = x0; i < canvas.side; ++i, x = x + 1 == kPrintTexels ? 0 : x + 1) to[i] += from[x];
  }
}

}  // namespace weft::agents::sim
