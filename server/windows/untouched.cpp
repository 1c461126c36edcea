#include "server/windows/untouched.hpp"

#include <algorithm>

namespace weft::server {

bool is_untouched(const WindowDefinition& definition, const Window& window, const Snapshot& then,
                  const Snapshot& now) {
  if (then.shared_labels() != now.shared_labels()) return false;
  // What is not there, or not within reach, may come from anywhere.
  if (!definition.centre || window.place(*definition.centre) == nullptr) return false;
  const auto is_in = [&](const PlaceId& place) { return window.place(place) != nullptr; };
  if (!std::all_of(definition.route.begin(), definition.route.end(), is_in)) return false;
  ExperienceId last;
  for (const auto& [id, place] : window.places) {
    if (id.experience == last) continue;  // they are sorted
    last = id.experience;
    if (then.experience(last) != now.experience(last)) return false;
  }
  return true;
}

}  // namespace weft::server
