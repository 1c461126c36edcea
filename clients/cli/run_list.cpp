#include "clients/cli/run_list.hpp"

#include <algorithm>
#include <functional>

#include "core/network/imported.hpp"

namespace weft::cli {

std::vector<Run> runs_of(const Window& network) {
  std::vector<Run> runs;
  for (std::size_t first = 0; first < network.places.size();) {
    const ExperienceId id = network.places.key_at(first).experience;
    std::size_t end = first;
    while (end < network.places.size() && network.places.key_at(end).experience == id) ++end;
    const Place& place = network.places.value_at(first);
    runs.push_back({.id = id,
                    .places = end - first,
                    .middle = network.places.key_at(first + (end - first) / 2),
                    .robot = place.robot,
                    .is_imported = place.method == kImportedMethod});
    first = end;
  }
  std::ranges::stable_sort(runs, std::greater<>{}, &Run::places);
  return runs;
}

}  // namespace weft::cli
