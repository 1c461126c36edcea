#include "agents/bodies/sim/floor/planks.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kWidthM = 0.12;         // mean
constexpr double kWidthJitterM = 0.018;  // of each rim, both ways: rows of one width would repeat
constexpr double kPitchM = 1.2;          // mean length
constexpr double kJitterM = 0.3;         // of each end, both ways together
constexpr double kNodeM = 0.08;          // along the grain, between two of its cross sections
constexpr double kBendM = 0.02;          // that the grain is bent by at most
constexpr double kGapM = 0.0018;         // that a plank's rim is rounded over
constexpr int kNodes = 22;
constexpr int kAcross = static_cast<int>((kWidthM + 2 * kWidthJitterM + 2 * kBendM) / kTexelM) + 2;

struct Knot {
  double along = 0.0, across = 0.0, size_m = 0.0;
};

struct Plank {
  double from = 0.0, to = 0.0;    ///< along x
  double low = 0.0, width = 0.0;  ///< across: its lower rim, and from there
  double grey = 0.0, warmth = 0.0;
  double tilt = 0.0, wave_m = 0.0, phase = 0.0;
  std::vector<Knot> knots;
  std::vector<float> grain;  ///< kNodes cross sections of kAcross
};

Random random_of(std::uint64_t seed, std::int64_t row, std::int64_t piece, std::uint64_t stream) {
  return Random(seed * 0x9E3779B97F4A7C15ULL ^ static_cast<std::uint64_t>(row) * 0xC2B2AE3D27D4EB4FULL ^
                static_cast<std::uint64_t>(piece) * 0x165667B19E3779F9ULL)
      .fork(stream);
}

/// Returns where piece `piece` of a row begins, m; rows are shifted against each other.
double begin_of(std::uint64_t seed, std::int64_t row, std::int64_t piece) {
  const double shift = random_of(seed, row, 0, 1).uniform(0.0, kPitchM);
  return shift + static_cast<double>(piece) * kPitchM + random_of(seed, row, piece, 2).uniform(0.0, kJitterM);
}

double low_of(std::uint64_t seed, std::int64_t row) {
  return static_cast<double>(row) * kWidthM + random_of(seed, row, 0, 5).uniform(-kWidthJitterM, kWidthJitterM);
}

/// Returns annual rings seen from the side: layers of a few widths, which last for some decimetres.
std::vector<float> grain_of(Random random) {
  constexpr double kWidths[] = {0.0013, 0.003, 0.007, 0.018};
  constexpr double kGreys[] = {5.0, 6.0, 8.0, 7.0};
  constexpr double kLasts = 0.8;  // share that goes on from one cross section to the next
  std::vector<float> grain(static_cast<std::size_t>(kNodes) * kAcross, 0.0F);
  for (int size = 0; size < 4; ++size) {
    const double per_texel = kTexelM / kWidths[size];
    std::vector<double> layers(static_cast<std::size_t>(kAcross * per_texel) + 3);
    for (double& layer : layers) layer = random.normal();
    for (int node = 0; node < kNodes; ++node) {
      for (double& layer : layers) layer = kLasts * layer + std::sqrt(1.0 - kLasts * kLasts) * random.normal();
      for (int i = 0; i < kAcross; ++i) {
        const double at = i * per_texel;
        const auto below = static_cast<std::size_t>(at);
        const double share = at - static_cast<double>(below);
        grain[static_cast<std::size_t>(node * kAcross + i)] +=
            static_cast<float>(kGreys[size] * ((1.0 - share) * layers[below] + share * layers[below + 1]));
      }
    }
  }
  return grain;
}

Plank plank_of(std::uint64_t seed, std::int64_t row, std::int64_t piece) {
  Plank plank;
  plank.from = begin_of(seed, row, piece);
  plank.to = begin_of(seed, row, piece + 1);
  plank.low = low_of(seed, row);
  plank.width = low_of(seed, row + 1) - plank.low;
  Random random = random_of(seed, row, piece, 3);
  plank.grey = random.normal(0.0, 13.0);
  plank.warmth = random.normal(0.0, 0.06);
  plank.tilt = random.normal(0.0, 0.004);
  plank.wave_m = random.uniform(0.0, 0.004);
  plank.phase = random.uniform(0.0, 6.28);
  for (auto knots = random.below(3); knots > 0; --knots) {
    plank.knots.push_back({random.uniform(0.05, kPitchM - kJitterM), random.uniform(0.02, plank.width - 0.02),
                           random.uniform(0.003, 0.009)});
  }
  plank.grain = grain_of(random.fork(4));
  return plank;
}

/// Holds the grain's own coordinate across the plank: it runs at a slant, in waves, and around knots.
struct Bend {
  double across = 0.0;
  double dark = 0.0;  ///< of knots
};
Bend bent(const Plank& plank, double along, double across, double drift) {
  Bend bend{across + drift, 0.0};
  for (const Knot& knot : plank.knots) {
    const double u = (along - knot.along) / (5.0 * knot.size_m);
    const double v = (across - knot.across) / knot.size_m;
    if (std::abs(u) > 2.5 || std::abs(v) > 5.0) continue;  // nothing is left of it there
    const double r2 = u * u + 0.25 * v * v;
    // Layers that would pass through the knot are pushed aside.
    bend.across -= (v > 0.0 ? 1.0 : -1.0) * knot.size_m * std::exp(-r2) * std::min(1.0, std::abs(v));
    const double within = std::hypot(0.7 * (along - knot.along), across - knot.across) / knot.size_m;
    bend.dark += 48.0 * std::clamp(1.4 - within, 0.0, 1.0) * (0.8 + 0.2 * std::sin(9.0 * within));
  }
  return bend;
}

float grain_at(const Plank& plank, int node, float share, double across) {
  const double at = std::clamp((across + kBendM) / kTexelM, 0.0, kAcross - 2.0);
  const auto below = static_cast<int>(at);
  const auto between = static_cast<float>(at - below);
  const float* const near = plank.grain.data() + static_cast<std::ptrdiff_t>(node) * kAcross + below;
  const float* const far = near + kAcross;
  return (1.0F - share) * (near[0] + between * (near[1] - near[0])) + share * (far[0] + between * (far[1] - far[0]));
}

/// Holds what is the same for all rows of a canvas, for each column on a plank.
struct Columns {
  int first = 0;
  std::vector<double> along, drift;  ///< from the plank's begin; of the grain
  std::vector<int> node;
  std::vector<float> share;  ///< of the node after it
};
Columns columns_of(const Plank& plank, const Canvas& canvas) {
  const auto column = [&](double x) {
    return std::clamp(static_cast<int>(std::ceil((x - canvas.x0_m) / canvas.texel_m - 0.5)), 0, canvas.side);
  };
  Columns columns;
  columns.first = column(plank.from);
  for (int i = columns.first, end = column(plank.to); i < end; ++i) {
    const double along = canvas.x0_m + (i + 0.5) * canvas.texel_m - plank.from;
    const double node = std::min(along / kNodeM, kNodes - 1.001);
    const auto before = static_cast<int>(node);
    const auto u = static_cast<float>(node - before);
    columns.along.push_back(along);
    columns.drift.push_back(plank.tilt * along + plank.wave_m * std::sin(7.0 * along + plank.phase));
    columns.node.push_back(before);
    columns.share.push_back(u * u * (3.0F - 2.0F * u));
  }
  return columns;
}

void add_row(const Plank& plank, const Columns& columns, const Layer& layer, int j) {
  const Canvas& canvas = layer.canvas;
  const double across = canvas.y0_m + (j + 0.5) * canvas.texel_m - plank.low;
  const double rim_across = std::min(across, plank.width - across);
  float* const to = canvas.values.data() + static_cast<std::ptrdiff_t>(j) * canvas.side + columns.first;
  for (std::size_t i = 0; i < columns.along.size(); ++i) {
    const double along = columns.along[i];
    const Bend bend = bent(plank, along, across, columns.drift[i]);
    const auto grain = static_cast<double>(grain_at(plank, columns.node[i], columns.share[i], bend.across));
    const double rim = std::min(rim_across, std::min(along, plank.to - plank.from - along));
    const double gap = std::max(1.0 - rim / kGapM, 0.0);
    to[i] += static_cast<float>(layer.channel == Channel::grey ? plank.grey + grain - bend.dark - 45.0 * gap
                                                               : plank.warmth - 0.003 * grain + 0.002 * bend.dark);
  }
}

}  // namespace

void add_planks(std::uint64_t seed, const Layer& layer) {
  const Canvas& canvas = layer.canvas;
  const double x_end = canvas.x0_m + canvas.side * canvas.texel_m;
  const double y_end = canvas.y0_m + canvas.side * canvas.texel_m;
  const auto row_at = [seed](double y) {
    const auto row = static_cast<std::int64_t>(std::floor(y / kWidthM));
    if (y < low_of(seed, row)) return row - 1;
    return y < low_of(seed, row + 1) ? row : row + 1;
  };
  for (std::int64_t row = row_at(canvas.y0_m); row <= row_at(y_end); ++row) {
    const auto first = static_cast<std::int64_t>(std::floor(canvas.x0_m / kPitchM)) - 3;
    for (std::int64_t piece = first; begin_of(seed, row, piece) < x_end; ++piece) {
      if (begin_of(seed, row, piece + 1) <= canvas.x0_m) continue;
      const Plank plank = plank_of(seed, row, piece);
      const Columns columns = columns_of(plank, canvas);
      for (int j = 0; j < canvas.side; ++j) {
        const double across = canvas.y0_m + (j + 0.5) * canvas.texel_m - plank.low;
        if (across >= 0.0 && across < plank.width) add_row(plank, columns, layer, j);
      }
    }
  }
}

}  // namespace weft::agents::sim
