#include "agents/bodies/sim/hall/unsteady_light.hpp"

#include <algorithm>

#include "agents/bodies/sim/lamps.hpp"

namespace weft::agents::sim {

UnsteadyLight::UnsteadyLight(const HallLight& light, std::span<const Quad> quads, const QuadScene* in_the_way)
    : all_(light.on(quads, in_the_way)) {
  for (std::size_t i = 0; i < light.lamps().size(); ++i)
    if (is_unsteady(light.lamps()[i])) parts_.push_back({light.lamps()[i], light.by_lamp(i, quads, in_the_way)});
}

std::vector<QuadLight> UnsteadyLight::at(double time_s) const {
  std::vector<QuadLight> now = all_;
  for (const Part& part : parts_) {
    const auto missing = static_cast<float>(1.0 - share_at(part.lamp, time_s));
    if (missing <= 0.0F) continue;
    for (std::size_t quad = 0; quad < now.size(); ++quad)
      for (std::size_t corner = 0; corner < now[quad].at.size(); ++corner)
        now[quad].at[corner] = std::max(0.0F, now[quad].at[corner] - missing * part.light[quad].at[corner]);
  }
  return now;
}

}  // namespace weft::agents::sim
