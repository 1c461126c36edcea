#include "agents/bodies/sim/hall/ceiling_surface.hpp"

#include <array>

#include "agents/bodies/sim/hall/panels.hpp"

namespace weft::agents::sim {
namespace {

/// Describes one of the four faces of a corrugation: where it begins and ends across, and how far below the ceiling.
struct Fold {
  float from_m, to_m, from_below_m, to_below_m;
};
constexpr float kPeriodM = 0.25F;
constexpr float kDeepM = 0.06F;
constexpr std::array<Fold, 4> kFolds = {{{0.0F, 0.10F, 0.0F, 0.0F},
                                         {0.10F, 0.14F, 0.0F, kDeepM},
                                         {0.14F, 0.21F, kDeepM, kDeepM},
                                         {0.21F, 0.25F, kDeepM, 0.0F}}};

/// Adds trapezoidal steel whose ribs run along y, every 0.25 m.
void add_sheet(const Quad& whole, std::vector<Quad>& quads) {
  constexpr float length_m = 4.0F;  // light is told at its ends
  const float width = whole.across.norm();
  const float depth = whole.up.norm();
  const auto rows = static_cast<int>(depth / length_m) + 1;
  const Eigen::Vector3f along = whole.up / static_cast<float>(rows);
  for (float x = 0.0F; x < width; x += kPeriodM) {
    for (const Fold& fold : kFolds) {
      for (int row = 0; row < rows; ++row) {
        Quad strip = whole;
        strip.corner = whole.corner + static_cast<float>(row) * along +
                       Eigen::Vector3f(x + fold.from_m, 0.0F, -fold.from_below_m);
        strip.across = {fold.to_m - fold.from_m, 0.0F, fold.from_below_m - fold.to_below_m};
        strip.up = along;
        quads.push_back(strip);
      }
    }
  }
}

}  // namespace

void add_ceiling(const Site& site, const Quad& whole, std::vector<Quad>& quads) {
  if (site.hall.ceiling.kind == CeilingKind::plain) {
    add_panels(whole, quads);
    return;
  }
  Quad shown = whole;
  shown.stuff = Stuff::mural;
  if (site.hall.ceiling.kind == CeilingKind::sheet) {
    add_sheet(shown, quads);
  } else {
    add_panels(shown, quads);
  }
}

}  // namespace weft::agents::sim
