#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/ids.hpp"
#include "core/network/registration.hpp"
#include "core/network/relation.hpp"
#include "core/network/rule.hpp"
#include "core/shared_row.hpp"
#include "core/time.hpp"

namespace weft {

/// Refers to a content's bytes by their hash; `size` is of the canonical uncompressed bytes.
struct ContentRef {
  ContentHash hash;
  std::uint64_t size = 0;
  auto operator<=>(const ContentRef&) const = default;
};

/// Describes a node of the network. Never edited: superseded or retired by a later revision.
struct Place {
  PlaceId id;
  std::uint32_t entity_version = 1;  ///< one more each time the place is known better
  std::string method;                ///< whose content this is
  std::uint32_t content_format = 1;
  ContentRef content;
  RobotId robot;
  std::uint64_t frame = 0;  ///< the body's frame counter when the place was kept
  SensorTime seen_at{};     ///< the robot's sensor clock; for records
  bool operator==(const Place&) const = default;
};

/// Tells in which way a relation came about.
enum class Origin : std::uint8_t {
  odometry = 1,  ///< seen: between consecutive places of one experience
  blind = 2,     ///< between consecutive places, vision was blind on the way: integrated commands or wheels
  stitch = 3,    ///< a localisation, or the weaver
};
const char* to_string(Origin origin);

/// Tells in which directions an edge's method can drive it. Localising works both ways, driving need not.
enum class Drivable : std::uint8_t { none = 0, a_to_b = 1, b_to_a = 2, both = 3 };

/// Identifies an edge by its ends, in the order written; one edge a pair. Odometry: b.index == a.index + 1.
struct EdgeId {
  PlaceId a;
  PlaceId b;
  auto operator<=>(const EdgeId&) const = default;
};

/// Describes an edge of the network. Its members are ordered to leave little room between them: a map has millions.
struct Edge {
  EdgeId id;
  std::uint32_t entity_version = 1;
  std::uint32_t inliers = 0;  ///< evidence of a stitch; 0 where the method counts none
  float overlap = 0.0F;       ///< evidence of a stitch: share of b's view seen in a, [0, 1]
  Origin origin = Origin::odometry;
  Drivable drivable = Drivable::a_to_b;
  Relation a_from_b;
  std::string method;  ///< what a robot needs to drive it
};

/// Holds one run of one robot. What was taken out of the map, or is damaged, is missing from `places` and `chain`.
struct Experience {
  ExperienceId id;
  RobotId robot;
  std::string name;  ///< label for people, may be empty
  std::string method;
  bool sealed = false;
  std::string seal_reason;
  std::uint32_t extent = 0;  ///< indices given so far, those of missing places too: the run goes on here
  SharedRow<Place> places;   ///< sorted by index
  SharedRow<Edge> chain;     ///< sorted; each joins a place and the one after it, both there
  /// Holds every stitch that touches a place of this experience (so each stands in up to two), sorted by id.
  SharedItems<Edge> stitches;

  /// Describes an end of a stitch that lies in this experience.
  struct StitchEnd {
    std::uint32_t place = 0;   ///< index into places
    std::uint32_t stitch = 0;  ///< index into stitches
    auto operator<=>(const StitchEnd&) const = default;
  };
  /// Lists the ends, sorted; made by `index_stitches` so that the stitches of a place are found from either end.
  std::vector<StitchEnd> stitch_ends;

  /// Returns the place with that index; null when there is none.
  const Place* place(std::uint32_t index) const;
  /// Returns the odometry edge from that place to the one after it; null when there is none.
  const Edge* hop(std::uint32_t index) const;
};

/// Sorts `stitches` and makes `stitch_ends` anew; to be called after either was changed.
void index_stitches(Experience& experience);

struct Apart;  // core/network/apart.hpp

/// Holds the network at one revision. Immutable; revisions share what did not change. Cheap to copy.
class Snapshot {
 public:
  using Experiences = std::map<ExperienceId, std::shared_ptr<const Experience>>;
  using Labels = std::map<std::string, PlaceId>;
  using Aparts = std::vector<Apart>;
  using Rules = std::map<std::string, Rule>;
  using Registrations = std::map<std::string, Registration>;

  Snapshot();
  /// Takes `aparts` sorted, each `ordered`; null: none, as of rules and
  /// registrations.
  Snapshot(Revision revision, Experiences experiences, std::shared_ptr<const Labels> labels,
           std::shared_ptr<const Aparts> aparts = nullptr, std::shared_ptr<const Rules> rules = nullptr,
           std::shared_ptr<const Registrations> registrations = nullptr);

  Revision revision() const { return revision_; }
  const Experiences& experiences() const { return experiences_; }
  const Labels& labels() const { return *labels_; }
  std::shared_ptr<const Labels> shared_labels() const { return labels_; }
  /// Returns the pairs of stretches that operators vouch to be different floors; sorted. Part of neither windows nor
  /// digests.
  const Aparts& aparts() const { return *aparts_; }
  std::shared_ptr<const Aparts> shared_aparts() const { return aparts_; }
  /// Returns what operators have laid down, by name; stays whatever becomes of the places. Part of neither windows
  /// nor digests.
  const Rules& rules() const { return *rules_; }
  std::shared_ptr<const Rules> shared_rules() const { return rules_; }
  /// Returns the floor plans that operators have registered, by name; stays whatever becomes of the places. Part of
  /// neither windows nor digests.
  const Registrations& registrations() const { return *registrations_; }
  std::shared_ptr<const Registrations> shared_registrations() const { return registrations_; }

  const Experience* experience(ExperienceId id) const;
  const Place* place(const PlaceId& id) const;
  /// Calls `visit(const Edge&)` for each edge at `id` (either end), odometry first, then stitches by id.
  template <class Visit>
  void for_each_edge(const PlaceId& id, Visit&& visit) const;

  /// Counts the experiences with at least one place.
  std::uint64_t experience_count() const;
  std::uint64_t place_count() const;
  std::uint64_t stitch_count() const;

 private:
  Revision revision_;
  Experiences experiences_;
  std::shared_ptr<const Labels> labels_;
  std::shared_ptr<const Aparts> aparts_;
  std::shared_ptr<const Rules> rules_;
  std::shared_ptr<const Registrations> registrations_;
};

template <class Visit>
void Snapshot::for_each_edge(const PlaceId& id, Visit&& visit) const {
  const Experience* const found = experience(id.experience);
  if (found == nullptr || id.index >= found->extent) return;
  const Edge* const before = id.index > 0 ? found->hop(id.index - 1) : nullptr;
  if (before != nullptr) visit(*before);
  const Edge* const after = found->hop(id.index);
  if (after != nullptr) visit(*after);
  const auto& ends = found->stitch_ends;
  for (auto at = std::lower_bound(ends.begin(), ends.end(), Experience::StitchEnd{id.index, 0});
       at != ends.end() && at->place == id.index; ++at) {
    visit(found->stitches[at->stitch]);
  }
}

}  // namespace weft
