#include <algorithm>
#include <array>
#include <cmath>

#include "agents/agent/process/calibrate/jobs.hpp"
#include "agents/agent/process/words.hpp"
#include "drawing/canvas.hpp"

namespace weft::agents {
namespace {

using drawing::Canvas;
using drawing::kInk;
using drawing::kQuiet;
using Ink = drawing::Colour;

constexpr Ink kRed = {0.80, 0.15, 0.12};
constexpr double kWide = 1240.0;
constexpr double kMargin = 40.0;
constexpr double kPlotTop = 100.0;
constexpr double kPlotWide = 800.0;
constexpr double kBarsLeft = kMargin + kPlotWide + 50.0;
constexpr double kBarLongest = 170.0;

/// Returns a colour: dark blue for nothing, over green to yellow for `share` = 1 (close to "viridis", which prints
/// well in grey).
Ink heat(double share) {
  constexpr std::array<Ink, 5> kSteps = {
      {{0.27, 0.00, 0.33}, {0.23, 0.32, 0.55}, {0.13, 0.57, 0.55}, {0.37, 0.79, 0.38}, {0.93, 0.83, 0.10}}};
  const double at = std::clamp(share, 0.0, 1.0) * 4.0;
  const auto low = static_cast<std::size_t>(std::min(at, 3.0));
  const double part = at - static_cast<double>(low);
  const auto mix = [&](double a, double b) { return a + part * (b - a); };
  return {mix(kSteps[low].r, kSteps[low + 1].r), mix(kSteps[low].g, kSteps[low + 1].g),
          mix(kSteps[low].b, kSteps[low + 1].b)};
}

/// Returns the largest round number of pixels, of 0.01 to 20, up to this one; below these 0.01.
double rounded(double px) {
  double best = 0.01;
  for (const double step : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
    if (step <= px) best = step;
  return best;
}

/// Holds the scales from which the drawing's sizes follow.
struct Scale {
  double image = 1.0;        ///< sheet units a pixel
  double full_px = 1.0;      ///< residual of the brightest colour: nineteen of twenty are smaller
  double arrow_units = 1.0;  ///< sheet units a pixel of residual
};
Scale scale_of(const CameraFit& fit) {
  std::vector<double> lengths;
  for (const ImageFit& image : fit.images)
    for (const Eigen::Vector2d& e : image.error_px)
      if (image.used) lengths.push_back(e.norm());
  const auto at = lengths.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(lengths.size() - 1));
  std::nth_element(lengths.begin(), at, lengths.end());
  Scale scale;
  scale.image = kPlotWide / fit.camera.width;
  scale.full_px = std::max(*at, 0.01);
  scale.arrow_units = 26.0 / scale.full_px;
  return scale;
}

void draw_arrows(Canvas& sheet, const CameraFit& fit, const Scale& scale) {
  sheet.box({kMargin, kPlotTop}, kPlotWide, scale.image * fit.camera.height, kQuiet, false);
  for (const ImageFit& image : fit.images) {
    for (std::size_t i = 0; i < image.pixels.size() && image.used; ++i) {
      const double x = kMargin + scale.image * (image.pixels[i].x() + 0.5);
      const double y = kPlotTop + scale.image * (image.pixels[i].y() + 0.5);
      const Eigen::Vector2d& e = image.error_px[i];
      const double units = scale.arrow_units * std::min(1.0, 2.0 * scale.full_px / std::max(e.norm(), 1e-9));
      const Ink ink = heat(e.norm() / scale.full_px);
      sheet.stroke({x, y}, {x + units * e.x(), y + units * e.y()}, ink, {1.3});
      sheet.dot({x, y}, 1.6, ink);
    }
  }
}

void draw_legend(Canvas& sheet, const Scale& scale, double top) {
  const double shown = rounded(scale.full_px);
  sheet.stroke({kMargin, top}, {kMargin + scale.arrow_units * shown, top}, kInk, {2.0});
  sheet.dot({kMargin, top}, 2.5, kInk);
  sheet.text({kMargin + 60.0, top + 5.0},
             text("%g px; from where a point was seen, dot, along its residual (seen - predicted)", shown), 13.0,
             kInk);
  constexpr int kSteps = 60;
  for (int i = 0; i < kSteps; ++i)
    sheet.box({kMargin + 3.0 * i, top + 22.0}, 3.5, 12.0, heat(static_cast<double>(i) / (kSteps - 1)), true);
  sheet.text({kMargin, top + 50.0}, "0", 12.0, kInk);
  sheet.text({kMargin + 3.0 * kSteps - 30.0, top + 50.0}, text("%.2f px", scale.full_px), 12.0, kInk);
  sheet.text({kMargin + 3.0 * kSteps + 30.0, top + 33.0},
             "size of the residual; 5 % are larger, drawn at most twice as long", 12.0, kQuiet);
}

/// Draws a bar an image; what is four times as large as usual, or more, fills the width.
void draw_bars(Canvas& sheet, const CameraFit& fit, double row) {
  double most = fit.rms_px;
  for (const ImageFit& image : fit.images) most = std::max(most, image.rms_px);
  const double unit = kBarLongest / std::min(most, 4.0 * fit.rms_px);
  const double left = kBarsLeft + 110.0;
  sheet.text({kBarsLeft, kPlotTop - 6.0}, "RMS of each image, px", 13.0, kInk);
  double y = kPlotTop + 8.0;
  for (const ImageFit& image : fit.images) {
    const double length = std::min(kBarLongest, unit * image.rms_px);
    const bool is_long = image.name.size() > 15;
    const double size = std::min(12.0, 0.8 * row);
    sheet.text({kBarsLeft, y + 0.72 * row}, is_long ? ".." + image.name.substr(image.name.size() - 13) : image.name,
               size, kInk);
    sheet.box({left, y + 0.12 * row}, std::max(1.0, length), 0.7 * row, image.used ? heat(0.45) : kRed, true);
    const double inside = length > kBarLongest - 40.0 ? -34.0 : 6.0;
    sheet.text({left + length + inside, y + 0.72 * row}, text("%.2f", image.rms_px), size,
               inside < 0.0 ? drawing::kWhite : kInk);
    y += row;
  }
  sheet.stroke({left + unit * fit.rms_px, kPlotTop + 4.0}, {left + unit * fit.rms_px, y + 4.0}, kInk, {1.0});
  sheet.text({kBarsLeft, y + 22.0}, text("line: all images that were used, %.3f px", fit.rms_px), 12.0, kInk);
  sheet.text({kBarsLeft, y + 40.0}, "red: disagrees with the others, left out", 12.0, kRed);
}

}  // namespace

Result<void> draw_residuals(const CameraFit& fit, const std::string& title, const std::string& file) {
  const Scale scale = scale_of(fit);
  const double plot = scale.image * fit.camera.height;
  const double row = std::clamp((plot - 20.0) / static_cast<double>(fit.images.size()), 11.0, 22.0);
  const double bars = row * static_cast<double>(fit.images.size()) + 60.0;
  Result<Canvas> canvas = Canvas::make(file, kWide, kPlotTop + std::max(plot + 80.0, bars) + 20.0);
  if (!canvas) return fail(canvas.error());
  Canvas& sheet = *canvas;
  sheet.text({kMargin, 44.0}, "What the calibration does not explain", 22.0, kInk);
  sheet.text({kMargin, 68.0},
             title + text("; %s, %d x %d pixels, %.3f px RMS", to_string(fit.camera.lens), fit.camera.width,
                          fit.camera.height, fit.rms_px),
             13.0, kQuiet);
  draw_arrows(sheet, fit, scale);
  draw_legend(sheet, scale, kPlotTop + plot + 24.0);
  draw_bars(sheet, fit, row);
  return canvas->finish();
}

}  // namespace weft::agents
