#include <cstdint>

#include "agents/bodies/sim/hall/shade.hpp"

namespace weft::agents::sim::avx2 {
namespace {

constexpr int kLanes = 8;
#include "agents/bodies/sim/hall/shade_body.hpp"

}  // namespace

void shade_face(const ShadeRays& rays) {
  shade(rays);
}

}  // namespace weft::agents::sim::avx2
