#include "clients/evaluate/topometric/charted_places.hpp"

#include <memory>
#include <utility>

#include "core/network/search.hpp"

namespace weft::evaluate::topometric {

using namespace agents;

Result<Topometric::Chart> chart_around(const TaughtMap& map, const Topometric& method, const PlaceId& centre) {
  std::vector<ChartPlace<TopometricContent>> around;
  for (const Reached& reached :
       breadth_first(map.snapshot(), centre, Topometric::chart_size.hops, Topometric::chart_size.places)) {
    const auto bytes = map.find(map.snapshot().place(reached.id)->content.hash);
    Result<TopometricContent> content = method.decode(*bytes);
    if (!content) return fail(content.error());
    around.push_back({reached.id, reached.depth, reached.centre_from_place,
                      std::make_shared<const TopometricContent>(std::move(*content))});
  }
  return method.chart(around);
}

Result<GridErrors> grid_errors_of(const TaughtMap& map, const Topometric& method, const std::vector<PlaceId>& places,
                                  std::size_t every, const TruePlaces& truth, const TrueHall& hall) {
  GridErrors errors;
  for (std::size_t i = every / 2; i < places.size(); i += every) {
    const auto site_from_place = truth.find(places[i]);
    if (site_from_place == truth.end()) continue;
    const Result<Topometric::Chart> chart = chart_around(map, method, places[i]);
    if (!chart) return fail(chart.error());
    errors.add(grid_errors(chart->grid, site_from_place->second, hall));
  }
  return errors;
}

}  // namespace weft::evaluate::topometric
