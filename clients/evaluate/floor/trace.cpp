#include "clients/evaluate/floor/trace.hpp"

#include <cmath>

namespace weft::evaluate::floor {

std::vector<double> metres_driven(const Trace& trace) {
  std::vector<double> along(trace.moments.size(), 0.0);
  for (std::size_t i = 1; i < along.size(); ++i) {
    const Pose2& a = trace.moments[i - 1].site_from_robot;
    const Pose2& b = trace.moments[i].site_from_robot;
    along[i] = along[i - 1] + std::hypot(b.x - a.x, b.y - a.y);
  }
  return along;
}

PlaceSet places_of(const Trace& taught) {
  PlaceSet places;
  for (const Moment& moment : taught.moments) {
    if (!moment.kept) continue;
    places.site_from_place[*moment.kept] = moment.site_from_robot;
    places.start_from_place[*moment.kept] = moment.start_from_robot;
  }
  return places;
}

}  // namespace weft::evaluate::floor
