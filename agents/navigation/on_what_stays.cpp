#include "agents/navigation/on_what_stays.hpp"

#include "core/network/search.hpp"

namespace weft::agents {

std::optional<Estimate> on_what_stays(const Estimate& believed, const Window& known, const Window& after) {
  const auto all = static_cast<std::uint32_t>(known.places.size());
  for (const Reached& reached : breadth_first(known, believed.place, all, all)) {
    if (after.place(reached.id) == nullptr) continue;
    return Estimate{reached.id, compose(inverse(reached.centre_from_place), believed.place_from_robot),
                    believed.blind_m};
  }
  return std::nullopt;
}

}  // namespace weft::agents
