#include "agents/bodies/sim/hall/obstacles.hpp"

#include "agents/bodies/sim/hall/movers.hpp"
#include "agents/bodies/sim/hall/shape.hpp"

namespace weft::agents::sim {
namespace {

/// Adds a hand pallet truck: its forks lie low ahead of its head, which carries a tiller.
void add_pallet_jack(const Pose2& pose, std::uint32_t who, std::vector<Quad>& quads) {
  const Shape shape{pose, quads};
  for (const double side : {-0.19, 0.19})
    shape.add(0.225, side, 0.0, 1.15, 0.16, 0.09, painted(Stuff::steel, 110.0F, who));
  shape.add(-0.575, 0.0, 0.05, 0.45, 0.5, 0.5, painted(Stuff::vehicle, 150.0F, who + 1));
  shape.add(-0.75, 0.0, 0.55, 0.05, 0.06, 0.6, painted(Stuff::steel, 60.0F, who + 2));
  shape.add(-0.75, 0.0, 1.15, 0.05, 0.3, 0.05, painted(Stuff::steel, 45.0F, who + 3));
}

}  // namespace

void add_obstacle(const Obstacle& obstacle, std::uint32_t who, std::vector<Quad>& quads) {
  const Pose2& pose = obstacle.site_from_obstacle;
  switch (obstacle.kind) {
    case Obstacle::Kind::crate:
      Shape{pose, quads}.add(0.0, 0.0, 0.0, obstacle.length_m, obstacle.width_m, obstacle.height_m,
                             painted(Stuff::load, 115.0F, who * 13 + 5));
      return;
    case Obstacle::Kind::person:
      add_person(pose, who, 0.0, quads);
      return;
    case Obstacle::Kind::pallet_jack:
      add_pallet_jack(pose, who, quads);
      return;
  }
}

}  // namespace weft::agents::sim
