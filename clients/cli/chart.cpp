#include "clients/cli/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace weft::cli {
namespace {

using drawing::Canvas;

constexpr double kHead = 100.0;  // title, what it is about, legend
constexpr double kLeftOfChart = 80.0;
constexpr double kRightOfChart = 30.0;
constexpr double kBelowChart = 50.0;
constexpr double kChartWords = 11.0;  // sizes
constexpr double kAxisWords = 12.0;

/// Describes the part of the canvas that the chart takes, and the ranges that it shows.
struct Frame {
  double left = 0.0;
  double top = 0.0;
  double wide = 0.0;
  double tall = 0.0;
  Range x = {};
  Range y = {};
  drawing::Point at(const drawing::Point& point) const {
    return {left + wide * (point.x - x.low) / (x.high - x.low), top + tall * (y.high - point.y) / (y.high - y.low)};
  }
};

/// Returns the range, or one of width 1 about it when it has next to no width (below 1e-9).
Range sized(const Range& range) {
  return range.high - range.low < 1e-9 ? Range{range.low - 0.5, range.low + 0.5} : range;
}

std::string grid_words(double value, double step) {
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
    const std::string words = grid_words(k * x_step, x_step);
    canvas.stroke({x, frame.top}, {x, bottom}, drawing::kGrid, {1.0});
    canvas.text({x - 0.5 * canvas.width_of(words, kChartWords), bottom + 15.0}, words, kChartWords, drawing::kQuiet);
  }
  const double y_step = grid_step(frame.y.low, frame.y.high, 5);
  for (double k = std::ceil(frame.y.low / y_step); k * y_step <= frame.y.high; k += 1.0) {
    const double y = frame.at({0.0, k * y_step}).y;
    const std::string words = grid_words(k * y_step, y_step);
    canvas.stroke({frame.left, y}, {frame.left + frame.wide, y}, drawing::kGrid, {1.0});
    canvas.text({frame.left - 6.0 - canvas.width_of(words, kChartWords), y + 4.0}, words, kChartWords,
                drawing::kQuiet);
  }
}

void draw_curve(Canvas& canvas, const Frame& frame, const Curve& curve) {
  std::vector<drawing::Point> points;
  for (const drawing::Point& point : curve.points) points.push_back(frame.at(point));
  canvas.curve(points, curve.ink, curve.line);
}

void draw_legend(Canvas& canvas, const Chart& chart, double left, double y) {
  for (const Curve& curve : chart.curves) {
    canvas.stroke({left, y - 4.0}, {left + 20.0, y - 4.0}, curve.ink, {2.0, curve.line.dashed});
    canvas.text({left + 26.0, y}, curve.name, kChartWords, drawing::kInk);
    left += 44.0 + canvas.width_of(curve.name, kChartWords);
  }
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

Result<void> draw_chart(const Chart& chart, const std::string& file, double wide, double tall) {
  Result<Canvas> canvas = Canvas::make(file, wide, tall);
  if (!canvas) return fail(canvas.error());
  const Frame frame{kLeftOfChart,   kHead,         wide - kLeftOfChart - kRightOfChart, tall - kHead - kBelowChart,
                    sized(chart.x), sized(chart.y)};
  canvas->text({24.0, 32.0}, chart.title, 20.0, drawing::kInk);
  canvas->text({24.0, 54.0}, chart.about, kAxisWords, drawing::kQuiet);
  draw_legend(*canvas, chart, kLeftOfChart, kHead - 14.0);
  draw_grid(*canvas, frame);
  for (const Curve& curve : chart.curves) draw_curve(*canvas, frame, curve);
  const double middle = frame.left + 0.5 * (frame.wide - canvas->width_of(chart.x_label, kAxisWords));
  canvas->text({middle, frame.top + frame.tall + 34.0}, chart.x_label, kAxisWords, drawing::kInk);
  canvas->upright_text({26.0, frame.top + 0.5 * frame.tall}, chart.y_label, kAxisWords, drawing::kInk);
  return canvas->finish();
}

}  // namespace weft::cli
