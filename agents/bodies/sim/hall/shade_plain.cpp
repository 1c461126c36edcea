#include <cstdint>

#include "agents/bodies/sim/hall/shade.hpp"

namespace weft::agents::sim {
namespace plain {
namespace {

constexpr int kLanes = 4;
#include "agents/bodies/sim/hall/shade_body.hpp"

}  // namespace

void shade_face(const ShadeRays& rays) {
  shade(rays);
}

}  // namespace plain

ShadeFace shade_face() {
  return __builtin_cpu_supports("avx2") ? avx2::shade_face : plain::shade_face;
}

}  // namespace weft::agents::sim
