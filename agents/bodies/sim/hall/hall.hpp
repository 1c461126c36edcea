#pragma once
#include <memory>
#include <vector>

#include "agents/bodies/sim/hall/hall_light.hpp"
#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "agents/bodies/sim/hall/textures.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Holds a hall as cameras that look around see it; shared by all of them, one thread each.
class Hall {
 public:
  Hall(const Site& site, const FloorSource& floor, const Photographed& photographed);

  const std::vector<Quad>& quads() const { return quads_; }
  const QuadScene& scene() const { return scene_; }
  const Textures& textures() const { return textures_; }

 private:
  std::vector<Quad> quads_;
  QuadScene scene_;
  Textures textures_;
};

}  // namespace weft::agents::sim
