#include "core/network/network.hpp"

#include <algorithm>
#include <utility>

#include "core/network/apart.hpp"
#include "core/network/index_of.hpp"

namespace weft {

const char* to_string(Origin origin) {
  switch (origin) {
    case Origin::odometry:
      return "odometry";
    case Origin::blind:
      return "blind";
    case Origin::stitch:
      return "stitch";
  }
  return "unknown";
}

namespace {

/// Finds a row by its index. It stands at that position where nothing before it is missing.
template <class Row>
const Row* find(const SharedRow<Row>& rows, std::uint32_t index) {
  if (index < rows.size() && index_of(rows[index]) == index) return &rows[index];
  const auto found = std::lower_bound(rows.begin(), rows.end(), index,
                                      [](const Row& row, std::uint32_t wanted) { return index_of(row) < wanted; });
  return found == rows.end() || index_of(*found) != index ? nullptr : &*found;
}

}  // namespace

const Place* Experience::place(std::uint32_t index) const {
  return find(places, index);
}

const Edge* Experience::hop(std::uint32_t index) const {
  return find(chain, index);
}

void index_stitches(Experience& experience) {
  experience.stitches.sort([](const Edge& first, const Edge& second) { return first.id < second.id; });
  experience.stitch_ends.clear();
  experience.stitch_ends.reserve(experience.stitches.size());  // more only for those within the experience
  for (std::size_t i = 0; i < experience.stitches.size(); ++i) {
    for (const PlaceId& end : {experience.stitches[i].id.a, experience.stitches[i].id.b}) {
      if (end.experience == experience.id)
        experience.stitch_ends.push_back({end.index, static_cast<std::uint32_t>(i)});
    }
  }
  std::sort(experience.stitch_ends.begin(), experience.stitch_ends.end());
}

Snapshot::Snapshot() : Snapshot({}, {}, std::make_shared<const Labels>()) {}

Snapshot::Snapshot(Revision revision, Experiences experiences, std::shared_ptr<const Labels> labels,
                   std::shared_ptr<const Aparts> aparts, std::shared_ptr<const Rules> rules,
                   std::shared_ptr<const Registrations> registrations)
    : revision_(revision),
      experiences_(std::move(experiences)),
      labels_(std::move(labels)),
      aparts_(aparts ? std::move(aparts) : std::make_shared<const Aparts>()),
      rules_(rules ? std::move(rules) : std::make_shared<const Rules>()),
      registrations_(registrations ? std::move(registrations) : std::make_shared<const Registrations>()) {}

const Experience* Snapshot::experience(ExperienceId id) const {
  const auto found = experiences_.find(id);
  return found == experiences_.end() ? nullptr : found->second.get();
}

const Place* Snapshot::place(const PlaceId& id) const {
  const Experience* const found = experience(id.experience);
  return found == nullptr ? nullptr : found->place(id.index);
}

std::uint64_t Snapshot::experience_count() const {
  return static_cast<std::uint64_t>(std::count_if(experiences_.begin(), experiences_.end(),
                                                  [](const auto& entry) { return !entry.second->places.empty(); }));
}

std::uint64_t Snapshot::place_count() const {
  std::uint64_t count = 0;
  for (const auto& [id, experience] : experiences_) count += experience->places.size();
  return count;
}

std::uint64_t Snapshot::stitch_count() const {
  std::uint64_t ends = 0;  // each stitch has two, whether they lie in one experience or in two
  for (const auto& [id, experience] : experiences_) ends += experience->stitch_ends.size();
  return ends / 2;
}

}  // namespace weft
