#include "agents/agent/process/told_footprint.hpp"

#include <algorithm>

namespace weft::agents {

double told_footprint_m(const Options& options) {
  double aside_m = 0.0;
  AllMethods::for_each([&]<class M>() {
    if (std::ranges::find(options.methods, M::name) == options.methods.end()) return;
    aside_m = std::max(aside_m, leaves_route_by_m<M>(std::get<Configured<M>>(options.settings).navigation));
  });
  return options.footprint_radius_m + aside_m;
}

}  // namespace weft::agents
