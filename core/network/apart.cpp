#include "core/network/apart.hpp"

#include <algorithm>
#include <utility>

namespace weft {
namespace {

bool has(const Stretch& stretch, const PlaceId& place) {
  return place.experience == stretch.experience && stretch.first <= place.index && place.index <= stretch.last;
}

bool has_places(const Snapshot& snapshot, const Stretch& stretch) {
  const Experience* const experience = snapshot.experience(stretch.experience);
  if (experience == nullptr) return false;
  const auto first = std::ranges::lower_bound(experience->places, stretch.first, {},
                                              [](const Place& place) { return place.id.index; });
  return first != experience->places.end() && (*first).id.index <= stretch.last;
}

Result<void> check_stretch(const Snapshot& snapshot, const Stretch& stretch) {
  const std::string name = "stretch " + to_string(stretch);
  if (stretch.first > stretch.last) {
    return fail(ErrorCode::invalid, name + ": its first place comes after its last; name the lower index first");
  }
  const Experience* const experience = snapshot.experience(stretch.experience);
  if (experience == nullptr) {
    return fail(ErrorCode::not_found, name + ": the map has no experience " + to_string(stretch.experience) +
                                          "; weft map info lists what it has");
  }
  if (stretch.last >= experience->extent) {
    return fail(ErrorCode::not_found, name + ": the last place of that experience is " +
                                          std::to_string(experience->extent == 0 ? 0 : experience->extent - 1) +
                                          "; end the stretch there or before");
  }
  if (has_places(snapshot, stretch)) return {};
  return fail(ErrorCode::not_found, name + ": none of its places is in the map; weft map log shows when they left");
}

Snapshot one_on(const Snapshot& snapshot, Snapshot::Aparts aparts) {
  return {{snapshot.revision().value + 1}, snapshot.experiences(),
          snapshot.shared_labels(),        std::make_shared<const Snapshot::Aparts>(std::move(aparts)),
          snapshot.shared_rules(),         snapshot.shared_registrations()};
}

}  // namespace

Apart ordered(Apart apart) {
  if (apart.other < apart.one) std::swap(apart.one, apart.other);
  return apart;
}

std::string to_string(const Apart& apart) {
  return to_string(apart.one) + " " + to_string(apart.other);
}

Result<void> check(const Snapshot& snapshot, const Apart& apart) {
  for (const Stretch& stretch : {apart.one, apart.other}) {
    if (auto fits = check_stretch(snapshot, stretch); !fits) return fits;
  }
  if (apart.one == apart.other) {
    return fail(ErrorCode::invalid, "stretch " + to_string(apart.one) +
                                        " is named twice: a floor is not apart from itself; name two stretches");
  }
  const std::uint32_t first = std::max(apart.one.first, apart.other.first);
  const std::uint32_t last = std::min(apart.one.last, apart.other.last);
  if (apart.one.experience == apart.other.experience && first <= last) {
    return fail(ErrorCode::invalid, "stretches " + to_string(apart.one) + " and " + to_string(apart.other) +
                                        " share the places " + std::to_string(first) + " to " + std::to_string(last) +
                                        ", which would be apart from themselves; name stretches without a place in "
                                        "common");
  }
  if (!std::ranges::binary_search(snapshot.aparts(), ordered(apart))) return {};
  return fail(ErrorCode::conflict, "stretches " + to_string(apart.one) + " and " + to_string(apart.other) +
                                       " are apart already; weft map apart --list shows all that are");
}

bool is_served(const Snapshot& snapshot, const Apart& apart) {
  return has_places(snapshot, apart.one) && has_places(snapshot, apart.other);
}

bool are_apart(const Snapshot& snapshot, const PlaceId& a, const PlaceId& b) {
  return std::ranges::any_of(snapshot.aparts(), [&](const Apart& apart) {
    return (has(apart.one, a) && has(apart.other, b)) || (has(apart.one, b) && has(apart.other, a));
  });
}

Snapshot with_apart(const Snapshot& snapshot, const Apart& apart) {
  Snapshot::Aparts aparts = snapshot.aparts();
  const Apart fresh = ordered(apart);
  const auto at = std::ranges::lower_bound(aparts, fresh);
  if (at == aparts.end() || *at != fresh) aparts.insert(at, fresh);
  return one_on(snapshot, std::move(aparts));
}

Snapshot without_apart(const Snapshot& snapshot, const Apart& apart) {
  Snapshot::Aparts aparts = snapshot.aparts();
  std::erase(aparts, ordered(apart));
  return one_on(snapshot, std::move(aparts));
}

}  // namespace weft
