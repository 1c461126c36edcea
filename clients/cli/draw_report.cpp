#include <algorithm>

#include "clients/chart/chart.hpp"
#include "clients/cli/teach_report.hpp"

namespace weft::cli {
namespace {

using charts::Chart;
using charts::Curve;
using charts::Dot;

/// The share of each stretch over all of its metres.
Curve line_of(const std::vector<msg::TaughtStretch>& report, double msg::TaughtStretch::*found, const char* name,
              const charts::Colour& ink, double thick) {
  Curve curve{name, {}, ink, Curve::Look::line, thick};
  for (const msg::TaughtStretch& stretch : report) {
    curve.dots.push_back({stretch.from_m, 100.0 * (stretch.*found)});
    curve.dots.push_back({stretch.to_m, 100.0 * (stretch.*found)});
  }
  return curve;
}

}  // namespace

Result<void> draw_report(const std::vector<msg::TaughtStretch>& report, const std::string& about,
                         const std::string& file) {
  const double from_m = report.empty() ? 0.0 : report.front().from_m;
  const double to_m = report.empty() ? 1.0 : report.back().to_m;
  Chart chart;
  chart.title = "Places that another robot will find again";
  chart.x_label = "metres taught, m";
  chart.y_label = "places found, %";
  chart.y_range = Dot{-4.0, 104.0};
  // Thick below thin: where they are the same, all of them show.
  chart.curves = {
      line_of(report, &msg::TaughtStretch::as_is, "as it is", charts::kSky, 6.0),
      line_of(report, &msg::TaughtStretch::half_light, "in half the light", charts::kVermilion, 3.2),
      line_of(report, &msg::TaughtStretch::worn, "on a worn floor", charts::kInk, 1.3),
      {"below it a robot will not find itself",
       {{from_m, 100.0 * kFoundEnough}, {to_m, 100.0 * kFoundEnough}},
       charts::kQuiet,
       Curve::Look::dashed,
       1.2},
  };
  constexpr double px_a_metre = 20.0;
  const double wide = std::clamp(90.0 + px_a_metre * (to_m - from_m), 760.0, 1800.0);
  // To this program an unavailable thing is a server.
  if (const Result<void> drawn = charts::draw_charts("Teach report", about, {chart}, 1, file, {wide, 360.0}); !drawn)
    return fail(ErrorCode::exhausted, drawn.error().message);
  return {};
}

}  // namespace weft::cli
