#include <algorithm>
#include <array>

#include "clients/cli/chart.hpp"
#include "clients/cli/teach_report.hpp"

namespace weft::cli {
namespace {

/// Returns the curve of one condition: the share found again of each stretch, in percent, over its metres.
Curve line_of(const std::vector<msg::TaughtStretch>& report, std::size_t condition, const drawing::Colour& ink,
              double thick) {
  Curve curve{words_for(report.front().found[condition].name), {}, ink, {thick}};
  for (const msg::TaughtStretch& stretch : report) {
    if (condition >= stretch.found.size()) continue;
    curve.points.push_back({stretch.from_m, 100.0 * stretch.found[condition].value});
    curve.points.push_back({stretch.to_m, 100.0 * stretch.found[condition].value});
  }
  return curve;
}

/// Returns a curve for each condition, thick ones below thin ones: where they coincide, all of them show.
std::vector<Curve> lines_of(const std::vector<msg::TaughtStretch>& report) {
  const std::array inks = {drawing::kSky, drawing::kVermilion, drawing::kInk, drawing::kQuiet};
  constexpr std::array thick = {6.0, 3.2, 1.3, 0.8};
  static_assert(thick.size() == msg::kReportConditions);
  std::vector<Curve> lines;
  if (report.empty()) return lines;
  for (std::size_t i = 0; i < std::min(report.front().found.size(), thick.size()); ++i)
    lines.push_back(line_of(report, i, inks[i], thick[i]));
  return lines;
}

}  // namespace

Result<void> draw_report(const std::vector<msg::TaughtStretch>& report, const std::string& about,
                         const std::string& file) {
  const double from_m = report.empty() ? 0.0 : report.front().from_m;
  const double to_m = report.empty() ? 1.0 : report.back().to_m;
  Chart chart;
  chart.title = "Teach report: places that another robot will find again";
  chart.about = about;
  chart.x_label = "metres taught, m";
  chart.y_label = "places found, metres seen, %";
  chart.x = {from_m, to_m};
  chart.y = {-4.0, 104.0};
  chart.curves = lines_of(report);
  if (!chart.curves.empty()) {
    const double bound = 100.0 * report.front().found.front().bound;
    chart.curves.push_back(
        {"below it a robot will not find itself", {{from_m, bound}, {to_m, bound}}, drawing::kQuiet, {1.2, true}});
  }
  constexpr double px_a_metre = 20.0;
  const double wide = std::clamp(90.0 + px_a_metre * (to_m - from_m), 760.0, 1800.0);
  return draw_chart(chart, file, wide, 430.0);
}

}  // namespace weft::cli
