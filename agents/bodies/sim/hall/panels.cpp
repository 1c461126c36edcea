#include "agents/bodies/sim/hall/panels.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr double kPanelM = 2.0;

}  // namespace

void add_panels(const Quad& whole, std::vector<Quad>& quads) {
  const auto columns = std::max(1, static_cast<int>(std::ceil(whole.across.norm() / kPanelM)));
  const auto rows = std::max(1, static_cast<int>(std::ceil(whole.up.norm() / kPanelM)));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Quad panel = whole;
      panel.across = whole.across / static_cast<float>(columns);
      panel.up = whole.up / static_cast<float>(rows);
      panel.corner = whole.corner + static_cast<float>(column) * panel.across + static_cast<float>(row) * panel.up;
      panel.pattern = static_cast<std::uint32_t>(quads.size());
      quads.push_back(panel);
    }
  }
}

Quad face(const Eigen::Vector3d& corner, const Eigen::Vector3d& across, const Eigen::Vector3d& up, Stuff stuff,
          double grey) {
  Quad quad;
  quad.corner = corner.cast<float>();
  quad.across = across.cast<float>();
  quad.up = up.cast<float>();
  quad.stuff = stuff;
  quad.grey = static_cast<float>(grey);
  return quad;
}

}  // namespace weft::agents::sim
