#include "agents/bodies/sim/floor/stamp.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr int kColumns = 64;  // whose places are worked out together, once for all their rows

/// Holds the texels whose centres lie within [low, high] metres, cut to the canvas.
struct Range {
  int first = 0;
  int last = -1;
};
Range range_of(double low_m, double high_m, double origin_m, const Canvas& canvas) {
  const double first = std::ceil((low_m - origin_m) / canvas.texel_m - 0.5);
  const double last = std::floor((high_m - origin_m) / canvas.texel_m - 0.5);
  if (last < 0.0 || first > canvas.side - 1) {
    return {};
  }
  return {static_cast<int>(std::max(0.0, first)), static_cast<int>(std::min<double>(canvas.side - 1, last))};
}

template <class Inside>
void add_where(const Canvas& canvas, Range xs, Range ys, double grey, double soft_m, Inside&& depth_of) {
  const double soft = std::max(soft_m, 0.7 * canvas.texel_m);
  const auto per_soft = static_cast<float>(1.0 / soft);
  const auto amount = static_cast<float>(grey);
  std::array<float, kColumns> x{};
  for (int from = xs.first; from <= xs.last; from += kColumns) {
    const int count = std::min(kColumns, xs.last - from + 1);
    for (int i = 0; i < count; ++i) {
      x[static_cast<std::size_t>(i)] = static_cast<float>(canvas.x0_m + (from + i + 0.5) * canvas.texel_m);
    }
    for (int j = ys.first; j <= ys.last; ++j) {
      const auto y = static_cast<float>(canvas.y0_m + (j + 0.5) * canvas.texel_m);
      float* row = canvas.values.data() + static_cast<std::ptrdiff_t>(j) * canvas.side + from;
      for (int i = 0; i < count; ++i) {
        const float share = 0.5F + depth_of(x[static_cast<std::size_t>(i)], y) * per_soft;
        row[i] += amount * std::min(std::max(share, 0.0F), 1.0F);
      }
    }
  }
}

}  // namespace

void stamp(const Ellipse& e, const Canvas& canvas) {
  const double reach = std::max(e.a_m, e.b_m) + std::max(e.soft_m, canvas.texel_m);
  const Range xs = range_of(e.x - reach, e.x + reach, canvas.x0_m, canvas);
  const Range ys = range_of(e.y - reach, e.y + reach, canvas.y0_m, canvas);
  const auto c = static_cast<float>(std::cos(e.angle));
  const auto s = static_cast<float>(std::sin(e.angle));
  const auto cx = static_cast<float>(e.x);
  const auto cy = static_cast<float>(e.y);
  const auto per_a = static_cast<float>(1.0 / e.a_m);
  const auto per_b = static_cast<float>(1.0 / e.b_m);
  const auto least = static_cast<float>(std::min(e.a_m, e.b_m));
  add_where(canvas, xs, ys, e.grey, e.soft_m, [&](float x, float y) {
    const float u = (c * (x - cx) + s * (y - cy)) * per_a;
    const float v = (c * (y - cy) - s * (x - cx)) * per_b;
    return (1.0F - std::sqrt(u * u + v * v)) * least;
  });
}

void stamp(const Stroke& k, const Canvas& canvas) {
  const double reach = k.half_width_m + std::max(k.soft_m, canvas.texel_m);
  const Range xs = range_of(std::min(k.x0, k.x1) - reach, std::max(k.x0, k.x1) + reach, canvas.x0_m, canvas);
  const Range ys = range_of(std::min(k.y0, k.y1) - reach, std::max(k.y0, k.y1) + reach, canvas.y0_m, canvas);
  const auto x0 = static_cast<float>(k.x0);
  const auto y0 = static_cast<float>(k.y0);
  const auto dx = static_cast<float>(k.x1 - k.x0);
  const auto dy = static_cast<float>(k.y1 - k.y0);
  const float per_length2 = 1.0F / std::max(1e-12F, dx * dx + dy * dy);
  const auto half = static_cast<float>(k.half_width_m);
  add_where(canvas, xs, ys, k.grey, k.soft_m, [&](float x, float y) {
    const float t = std::clamp(((x - x0) * dx + (y - y0) * dy) * per_length2, 0.0F, 1.0F);
    const float u = x - x0 - t * dx;
    const float v = y - y0 - t * dy;
    return half - std::sqrt(u * u + v * v);
  });
}

void stamp(const Arc& a, const Canvas& canvas) {
  const double soft = std::max(a.soft_m, canvas.texel_m);
  const double outer = a.radius_m + a.half_width_m + soft;
  // The box around its middle and the farthest that an end lies from there.
  const double reach = 2.0 * outer * std::sin(a.half_angle / 2.0) + a.half_width_m + soft;
  const double cx = a.x + a.radius_m * std::cos(a.middle);
  const double cy = a.y + a.radius_m * std::sin(a.middle);
  const Range xs = range_of(cx - reach, cx + reach, canvas.x0_m, canvas);
  const Range ys = range_of(cy - reach, cy + reach, canvas.y0_m, canvas);
  const auto x0 = static_cast<float>(a.x);
  const auto y0 = static_cast<float>(a.y);
  const auto c = static_cast<float>(std::cos(a.middle));
  const auto s = static_cast<float>(std::sin(a.middle));
  const auto radius = static_cast<float>(a.radius_m);
  const auto half = static_cast<float>(a.half_width_m);
  const auto end = static_cast<float>(a.radius_m * a.half_angle);
  const auto steep = static_cast<float>(soft / a.fade_m);  // depth grows as slowly at an end as that it fades there
  add_where(canvas, xs, ys, a.grey, soft, [&](float x, float y) {
    const float u = x - x0;
    const float v = y - y0;
    const float along = radius * std::atan2(c * v - s * u, c * u + s * v);
    return std::min(half - std::abs(std::sqrt(u * u + v * v) - radius), (end - std::abs(along)) * steep);
  });
}

}  // namespace weft::agents::sim
