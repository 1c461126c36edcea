#include "core/network/removal.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/network/apart.hpp"

namespace weft {
namespace {

std::string name_of(const Stretch& stretch) {
  return "places " + std::to_string(stretch.first) + " to " + std::to_string(stretch.last) + " of experience " +
         to_string(stretch.experience);
}

std::pair<std::size_t, std::size_t> positions(const Experience& experience, const Stretch& stretch) {
  const auto index = [](const Place& place) { return place.id.index; };
  const auto first = std::ranges::lower_bound(experience.places, stretch.first, {}, index);
  const auto last = std::ranges::upper_bound(experience.places, stretch.last, {}, index);
  return {first - experience.places.begin(), last - experience.places.begin()};
}

bool has_stitch(const Snapshot& snapshot, const EdgeId& id) {
  const Experience* const experience = snapshot.experience(id.b.experience);
  return experience != nullptr && std::ranges::binary_search(experience->stitches, id, {}, &Edge::id);
}

/// Takes places and stitches out of experiences; copies each when it is touched.
class Thinning {
 public:
  explicit Thinning(const Snapshot& snapshot) : experiences_(snapshot.experiences()) {}

  void take(const Stretch& stretch) {
    Experience* const experience = touch(stretch.experience);
    if (experience == nullptr) return;
    for (const Edge& stitch : experience->stitches) {
      for (const PlaceId& end : {stitch.id.a, stitch.id.b}) {
        if (end.experience == stretch.experience && is_in(stretch, end.index)) stitches_.insert(stitch.id);
      }
    }
    experience->places.erase_if([&](const Place& place) { return is_in(stretch, place.id.index); });
    experience->chain.erase_if(
        [&](const Edge& hop) { return is_in(stretch, hop.id.a.index) || is_in(stretch, hop.id.b.index); });
  }
  void take(const EdgeId& stitch) { stitches_.insert(stitch); }

  Snapshot::Experiences finish() {
    std::set<ExperienceId> ends;
    for (const EdgeId& stitch : stitches_) {
      ends.insert(stitch.a.experience);
      ends.insert(stitch.b.experience);
    }
    for (const ExperienceId id : ends) {
      Experience* const experience = touch(id);
      if (experience == nullptr) continue;
      experience->stitches.erase_if([&](const Edge& stitch) { return stitches_.contains(stitch.id); });
      index_stitches(*experience);
    }
    for (auto& [id, experience] : touched_) experiences_[id] = std::move(experience);
    return std::move(experiences_);
  }

 private:
  static bool is_in(const Stretch& stretch, std::uint32_t index) {
    return stretch.first <= index && index <= stretch.last;
  }
  Experience* touch(ExperienceId id) {
    const auto found = experiences_.find(id);
    if (found == experiences_.end()) return nullptr;
    auto& copy = touched_[id];
    if (!copy) copy = std::make_shared<Experience>(*found->second);
    return copy.get();
  }

  Snapshot::Experiences experiences_;
  std::map<ExperienceId, std::shared_ptr<Experience>> touched_;
  std::set<EdgeId> stitches_;
};

}  // namespace

std::string to_string(const Stretch& stretch) {
  return to_string(PlaceId{stretch.experience, stretch.first}) + ".." + std::to_string(stretch.last);
}

Result<void> check(const Snapshot& snapshot, const Removal& removal) {
  if (removal.empty()) return fail(ErrorCode::invalid, "nothing is named that could leave the map");
  for (const Stretch& stretch : removal.places) {
    if (stretch.first > stretch.last) {
      return fail(ErrorCode::invalid, name_of(stretch) + ": the first comes after the last");
    }
    const Experience* const experience = snapshot.experience(stretch.experience);
    if (experience == nullptr) {
      return fail(ErrorCode::not_found, "the map has no experience " + to_string(stretch.experience));
    }
    const auto [first, last] = positions(*experience, stretch);
    if (first == last) return fail(ErrorCode::not_found, name_of(stretch) + ": none of them is in the map");
  }
  for (const EdgeId& stitch : removal.stitches) {
    if (has_stitch(snapshot, stitch)) continue;
    return fail(ErrorCode::not_found, "the map has no stitch " + to_string(stitch.a) + " - " + to_string(stitch.b));
  }
  return {};
}

namespace {

/// Returns the stretches of those indices whose places are in the snapshot (`is_in`), or of those that are not.
std::vector<Stretch> runs(const Snapshot& snapshot, const std::vector<Stretch>& stretches, bool is_in) {
  std::set<Stretch> found;
  for (const Stretch& stretch : stretches) {
    const Experience* const experience = snapshot.experience(stretch.experience);
    if (experience == nullptr || experience->extent == 0) continue;
    const std::uint32_t last = std::min(stretch.last, experience->extent - 1);
    std::optional<Stretch> run;
    for (std::uint32_t index = stretch.first; index <= last; ++index) {
      const bool wanted = (experience->place(index) != nullptr) == is_in;
      if (wanted && run) run->last = index;
      if (wanted && !run) run = Stretch{stretch.experience, index, index};
      if (!wanted && run) found.insert(*std::exchange(run, std::nullopt));
    }
    if (run) found.insert(*run);
  }
  std::vector<Stretch> joined;
  for (const Stretch& next : found) {
    const bool goes_on =
        !joined.empty() && joined.back().experience == next.experience && next.first <= joined.back().last + 1;
    if (goes_on) {
      joined.back().last = std::max(joined.back().last, next.last);
    } else {
      joined.push_back(next);
    }
  }
  return joined;
}

Removal part(const Snapshot& snapshot, const Removal& removal, bool is_in) {
  Removal found;
  found.places = runs(snapshot, removal.places, is_in);
  const std::set<EdgeId> stitches(removal.stitches.begin(), removal.stitches.end());
  std::ranges::copy_if(stitches, std::back_inserter(found.stitches),
                       [&](const EdgeId& stitch) { return has_stitch(snapshot, stitch) == is_in; });
  return found;
}

}  // namespace

Removal present(const Snapshot& snapshot, const Removal& removal) {
  return part(snapshot, removal, true);
}

Removal absent(const Snapshot& snapshot, const Removal& removal) {
  return part(snapshot, removal, false);
}

std::uint64_t place_count(const Removal& removal) {
  std::uint64_t places = 0;
  for (const Stretch& stretch : removal.places) places += std::uint64_t{stretch.last} - stretch.first + 1;
  return places;
}

Snapshot without(const Snapshot& snapshot, const Removal& removal) {
  Thinning thinning(snapshot);
  for (const Stretch& stretch : removal.places) thinning.take(stretch);
  for (const EdgeId& stitch : removal.stitches) thinning.take(stitch);
  const Snapshot thinned({snapshot.revision().value + 1}, thinning.finish(), snapshot.shared_labels());
  Snapshot::Labels labels = snapshot.labels();
  std::erase_if(labels, [&](const auto& entry) { return thinned.place(entry.second) == nullptr; });
  Snapshot::Aparts aparts = snapshot.aparts();
  std::erase_if(aparts, [&](const Apart& apart) { return !is_served(thinned, apart); });
  const bool all_labels = labels.size() == snapshot.labels().size();
  const bool all_aparts = aparts.size() == snapshot.aparts().size();
  return {thinned.revision(),
          thinned.experiences(),
          all_labels ? snapshot.shared_labels() : std::make_shared<const Snapshot::Labels>(std::move(labels)),
          all_aparts ? snapshot.shared_aparts() : std::make_shared<const Snapshot::Aparts>(std::move(aparts)),
          snapshot.shared_rules(),
          snapshot.shared_registrations()};
}

}  // namespace weft
