#include "clients/evaluate/bearing/figures.hpp"

#include <algorithm>
#include <cmath>

#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/bearing/trials.hpp"

namespace weft::evaluate::bearing {
namespace {

using namespace charts;
using Look = Curve::Look;

bool is_ablation(const Trial& trial) {
  return trial.parts == Parts::profile_only || trial.parts == Parts::vision_only;
}

Chart path_chart(const Trial& trial, const Shown& shown) {
  Chart chart{trial.about, "x, m", "y, m", {}, true, {}, false};
  chart.curves = {{"taught", shown.taught, kInk, Look::line, 2.6},
                  {"first loop", shown.first, kVermilion, Look::line, 1.2},
                  {"last loop", shown.last, kBlue, Look::line, 1.2}};
  return chart;
}

Chart first_loop_chart(const Trial& trial, const Shown& shown) {
  Chart chart{trial.about, "along the taught way, m", "off where it believes to be, m", {}, false, {}, true};
  chart.curves = {{"driven", shown.error, kBlue, Look::line, 1.6},
                  {"model, distance by wheels alone", shown.model, kInk, Look::dashed, 1.6}};
  return chart;
}

Chart loops_chart(const Trial& trial, const Rows& rows, Seeds seeds) {
  Chart chart{trial.about, "loops driven", "error at the loop's end, m", {}, false, {}, true};
  Curve all{"seeds", {}, kSky, Look::dots, 2.0};
  Curve median{"median", {}, kBlue, Look::line, 1.8};
  for (std::size_t loop = 1; loop <= trial.loops; ++loop) {
    std::vector<double> errors = errors_after(rows, seeds, trial.name, loop);
    std::erase_if(errors, [](double error) { return !std::isfinite(error); });
    if (errors.empty()) break;
    for (const double error : errors) all.dots.push_back({static_cast<double>(loop), error});
    median.dots.push_back({static_cast<double>(loop), median_of(errors)});
  }
  chart.curves = {all, median};
  return chart;
}

/// One picture of charts; none of no charts.
Result<void> draw(const std::string& title, const std::string& about, const std::vector<Chart>& charts,
                  const std::filesystem::path& file, std::vector<std::string>& drawn,
                  const charts::ChartSize& size = {}) {
  if (charts.empty()) return {};
  constexpr std::size_t columns = 3;
  const Result<void> written = draw_charts(title, about, charts, std::min(columns, charts.size()), file, size);
  if (written) drawn.push_back(file.filename().string());
  return written;
}

}  // namespace

Result<std::vector<std::string>> draw_figures(const AllShown& shown, const Rows& rows, Seeds seeds,
                                              const std::filesystem::path& folder) {
  std::vector<Chart> paths;
  std::vector<Chart> firsts;
  std::vector<Chart> loops;
  std::vector<Chart> ablation;
  for (const Trial& trial : trials()) {
    const auto found = shown.find(trial.name);
    if (found != shown.end()) {
      (is_ablation(trial) ? ablation : paths).push_back(path_chart(trial, found->second));
      if (!is_ablation(trial) && !found->second.model.empty())
        firsts.push_back(first_loop_chart(trial, found->second));
    }
    if (trial.loops > 1 && !is_ablation(trial)) {
      Chart chart = loops_chart(trial, rows, seeds);
      if (!chart.curves.back().dots.empty()) loops.push_back(std::move(chart));
    }
  }
  const std::string of_first = "method bearing, seed " + std::to_string(seeds.first);
  const charts::ChartSize map{520.0, 420.0};
  std::vector<std::string> drawn;
  if (const auto done = draw("Taught and repeated", of_first, paths, folder / "paths.png", drawn, map); !done)
    return fail(done.error());
  if (const auto done = draw("The first loop against the model", of_first, firsts, folder / "first-loop.png", drawn);
      !done)
    return fail(done.error());
  if (const auto done =
          draw("Error after each loop", "method bearing, " + words_of(seeds), loops, folder / "loops.png", drawn);
      !done)
    return fail(done.error());
  if (const auto done = draw("One half of the method alone", of_first, ablation, folder / "ablation.png", drawn, map);
      !done)
    return fail(done.error());
  return drawn;
}

}  // namespace weft::evaluate::bearing
