#include "agents/navigation/agreement.hpp"

namespace weft::agents {

std::optional<Refusal> agreement(const Relation& predicted, const Relation& measured, double within_m,
                                 double within_rad) {
  const Difference apart = difference(predicted, measured);
  if (apart.metres > within_m) return Refusal{"stitch_disagrees", apart.metres, within_m};
  if (apart.radians > within_rad) return Refusal{"stitch_disagrees_in_heading", apart.radians, within_rad};
  return std::nullopt;
}

}  // namespace weft::agents
