#include "clients/evaluate/topometric/merge_trial.hpp"

#include <numbers>
#include <utility>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/edge_errors.hpp"
#include "clients/evaluate/topometric/shown_lines.hpp"
#include "clients/evaluate/topometric/spread.hpp"
#include "clients/evaluate/topometric/taught.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr double kDegreesOfStitch = 180.0 / std::numbers::pi;

/// Teaches both robots, one after the other. None: stopped.
Result<std::optional<Measured>> teach_both(const sim::Site& site, const Driven& driven,
                                           const std::vector<SitePoint>& first,
                                           const std::vector<SitePoint>& second) {
  Taught taught;
  for (const auto& [robot, line] : {std::pair("r1", &first), std::pair("r2", &second)}) {
    const Result<bool> led = teach(rider_of(on_beginning(site, robot, *line), robot, driven, 0), *line, taught);
    if (!led) return fail(led.error());
    if (!*led) return std::optional<Measured>();
  }
  const StitchErrors stitches = stitch_errors(taught);
  Measured measured;
  measured.score.values = {{"joined", stitches.metres.empty() ? 0.0 : 1.0},
                           {"stitches", static_cast<double>(stitches.metres.size())},
                           {"wrong", stitches.wrong},
                           {"stitch_m", quantile(stitches.metres, 0.5)},
                           {"stitch_deg", kDegreesOfStitch * quantile(stitches.radians, 0.5)}};
  measured.shown["first"] = path_of(taught.runs.front().moments);
  measured.shown["second"] = path_of(taught.runs.back().moments);
  return std::optional(std::move(measured));
}

}  // namespace

Result<std::optional<Measured>> measure_merge(const Scenes& scenes, const Driven& driven, const Overlap& overlap) {
  return teach_both(scenes.level11.site, driven, floor::stretch(scenes.level11.line, 0.0, overlap.first_to_m),
                    floor::stretch(scenes.level11.line, overlap.second_from_m, overlap.second_to_m));
}

Result<std::optional<Measured>> measure_aliasing(const Scenes& scenes, const Driven& driven) {
  return teach_both(scenes.aisles.site, driven, scenes.aisles.line, scenes.other_aisles);
}

}  // namespace weft::evaluate::topometric
