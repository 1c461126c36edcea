#include "clients/chart/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace weft::charts {
namespace {

constexpr double kLeft = 70.0;
constexpr double kRight = 20.0;
constexpr double kTop = 54.0;  // title and legend
constexpr double kBottom = 50.0;
constexpr double kHead = 70.0;  // of the picture

struct Range {
  double low = 0.0;
  double high = 1.0;
};

Range range_of(const Chart& chart, double Dot::*axis) {
  Range range{1e300, -1e300};
  for (const Curve& curve : chart.curves) {
    for (const Dot& dot : curve.dots) {
      if (!std::isfinite(dot.x) || !std::isfinite(dot.y)) continue;
      range.low = std::min(range.low, dot.*axis);
      range.high = std::max(range.high, dot.*axis);
    }
  }
  if (range.low > range.high) return {};
  if (range.high - range.low < 1e-9) return {range.low - 0.5, range.high + 0.5};
  return range;
}

Range widened(Range range, double share) {
  const double margin = share * (range.high - range.low);
  return {range.low - margin, range.high + margin};
}

/// The frame of a chart: where it is on the canvas, and what range it shows.
struct Frame {
  double left, top, wide, tall;
  Range x, y;
  Dot at(const Dot& dot) const {
    return {left + wide * (dot.x - x.low) / (x.high - x.low), top + tall * (y.high - dot.y) / (y.high - y.low)};
  }
};

Frame frame_of(const Chart& chart, const ChartSize& size, double left, double top) {
  Frame frame{left + kLeft,
              top + kTop,
              size.wide - kLeft - kRight,
              size.tall - kTop - kBottom,
              range_of(chart, &Dot::x),
              widened(range_of(chart, &Dot::y), 0.06)};
  if (chart.is_map) {
    frame.x = widened(frame.x, 0.04);
    // The one that has room to spare shows more.
    const double metre =
        std::min(frame.wide / (frame.x.high - frame.x.low), frame.tall / (frame.y.high - frame.y.low));
    const double x_middle = 0.5 * (frame.x.low + frame.x.high);
    const double y_middle = 0.5 * (frame.y.low + frame.y.high);
    frame.x = {x_middle - 0.5 * frame.wide / metre, x_middle + 0.5 * frame.wide / metre};
    frame.y = {y_middle - 0.5 * frame.tall / metre, y_middle + 0.5 * frame.tall / metre};
  }
  if (chart.y_from_zero) frame.y.low = 0.0;
  if (chart.y_range) frame.y = {chart.y_range->x, chart.y_range->y};
  return frame;
}

std::string number(double value, double step) {
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, std::abs(value) < 1e-9 * step ? 0.0 : value);
  return text.data();
}

void draw_grid(Canvas& canvas, const Frame& frame) {
  const double bottom = frame.top + frame.tall;
  const double x_step = grid_step(frame.x.low, frame.x.high, 8);
  for (double k = std::ceil(frame.x.low / x_step); k * x_step <= frame.x.high; k += 1.0) {
    const double x = frame.at({k * x_step, 0.0}).x;
    const std::string words = number(k * x_step, x_step);
    canvas.line({x, frame.top}, {x, bottom}, kGrid, 1.0);
    canvas.text(x - 0.5 * canvas.width(words, 11.0), bottom + 15.0, words, 11.0, kQuiet);
  }
  const double y_step = grid_step(frame.y.low, frame.y.high, 5);
  for (double k = std::ceil(frame.y.low / y_step); k * y_step <= frame.y.high; k += 1.0) {
    const double y = frame.at({0.0, k * y_step}).y;
    const std::string words = number(k * y_step, y_step);
    canvas.line({frame.left, y}, {frame.left + frame.wide, y}, kGrid, 1.0);
    canvas.text(frame.left - 6.0 - canvas.width(words, 11.0), y + 4.0, words, 11.0, kQuiet);
  }
}

void draw_curve(Canvas& canvas, const Frame& frame, const Curve& curve) {
  std::vector<Dot> dots;
  for (const Dot& dot : curve.dots) {
    const Dot at = frame.at(dot);
    if (curve.look == Curve::Look::steps && !dots.empty()) dots.push_back({at.x, dots.back().y});
    dots.push_back(at);
  }
  if (curve.look != Curve::Look::dots) {
    canvas.curve(dots, curve.ink, curve.thick, curve.look == Curve::Look::dashed);
    return;
  }
  for (const Dot& dot : dots) {
    if (std::isfinite(dot.x) && std::isfinite(dot.y)) canvas.mark(dot, curve.thick, curve.ink, true);
  }
}

constexpr double kLegendSize = 11.0;
constexpr double kLegendKey = 26.0;  // the line or dot before a name
constexpr double kLegendGap = 18.0;

/// Smaller letters where there are many names.
double legend_shrunk(Canvas& canvas, const Chart& chart, double room) {
  double wide = 0.0;
  for (const Curve& curve : chart.curves) {
    if (!curve.name.empty()) wide += kLegendKey + canvas.width(curve.name, kLegendSize) + kLegendGap;
  }
  return std::min(1.0, room / std::max(1.0, wide));
}

void draw_legend(Canvas& canvas, const Chart& chart, double left, double y, double room) {
  const double shrunk = legend_shrunk(canvas, chart, room);
  double x = left;
  for (const Curve& curve : chart.curves) {
    if (curve.name.empty()) continue;
    if (curve.look == Curve::Look::dots) {
      canvas.mark({x + 10.0 * shrunk, y - 4.0}, 2.5, curve.ink, true);
    } else {
      canvas.line({x, y - 4.0}, {x + 20.0 * shrunk, y - 4.0}, curve.ink, 2.0, curve.look == Curve::Look::dashed);
    }
    canvas.text(x + kLegendKey * shrunk, y, curve.name, kLegendSize * shrunk, kInk);
    x += shrunk * (kLegendKey + kLegendGap) + canvas.width(curve.name, kLegendSize * shrunk);
  }
}

void draw_chart(Canvas& canvas, const Chart& chart, const ChartSize& size, double left, double top) {
  const Frame frame = frame_of(chart, size, left, top);
  canvas.text(left + kLeft, top + 18.0, chart.title, 14.0, kInk);
  draw_legend(canvas, chart, left + kLeft, top + 40.0, size.wide - kLeft);
  draw_grid(canvas, frame);
  canvas.keep_within(frame.left, frame.top, frame.wide, frame.tall);
  for (const Curve& curve : chart.curves) draw_curve(canvas, frame, curve);
  canvas.free();
  const double middle = frame.left + 0.5 * (frame.wide - canvas.width(chart.x_label, 12.0));
  canvas.text(middle, frame.top + frame.tall + 34.0, chart.x_label, 12.0, kInk);
  canvas.upright_text(left + 16.0, frame.top + 0.5 * frame.tall, chart.y_label, 12.0, kInk);
}

}  // namespace

double grid_step(double low, double high, int many) {
  const double rough = (high - low) / many;
  const double size = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * size) return factor * size;
  }
  return 10.0 * size;
}

Result<void> draw_charts(const std::string& title, const std::string& about, const std::vector<Chart>& charts,
                         std::size_t columns, const std::filesystem::path& file, const ChartSize& size) {
  const std::size_t beside = std::min(columns, std::max<std::size_t>(1, charts.size()));
  const std::size_t rows = (charts.size() + beside - 1) / beside;
  Canvas canvas(file, 20.0 + size.wide * static_cast<double>(beside), kHead + size.tall * static_cast<double>(rows));
  canvas.text(24.0, 32.0, title, 20.0, kInk);
  canvas.text(24.0, 54.0, about, 12.0, kQuiet);
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::size_t row = i / beside;
    const std::size_t column = i % beside;
    draw_chart(canvas, charts[i], size, 10.0 + size.wide * static_cast<double>(column),
               kHead + size.tall * static_cast<double>(row));
  }
  return canvas.write();
}

}  // namespace weft::charts
