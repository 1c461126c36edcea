#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/network/apart.hpp"
#include "core/network/change.hpp"
#include "core/network/network.hpp"
#include "core/network/removal.hpp"

namespace weft::storage {

/// Makes a snapshot of stored rows in linear time (joining batches one by one would copy each experience again and
/// again). What is damaged or missing is left out and named, the rest is served.
class NetworkBuilder {
 public:
  /// Holds an experience's row: everything but its places and edges.
  struct Head {
    ExperienceId id;
    RobotId robot;
    std::string name{};
    std::string method{};
    bool sealed = false;
    std::string seal_reason{};
    std::uint64_t places = 0;  ///< indices given so far; each has a row, or was taken out
  };

  void add(Head head);
  /// Adds places and edges in any order. One that is added again replaces the earlier one.
  void add(Place place);
  void add(Edge edge, Revision since = {});
  /// Adds a row that is there and cannot be read; named, and so is what hangs on it.
  void add_damaged(const PlaceId& place, const std::string& why);
  /// Add a row that is none of this map: a rollback left it behind, or, of an edge, it is damaged and named so.
  void add_absent(const PlaceId& place);
  void add_absent(const EdgeId& edge);
  /// Adds places that were deleted for good: they are in no map any more, which is no damage, and what their rows say
  /// does not count.
  void add_deleted(const Stretch& stretch);
  /// Takes out, or brings back, at that revision; in the order of revisions. A stitch that was added later stays.
  void move(const Removal& removal, bool is_back, Revision at);
  /// Sets a label, in the order of revisions. A place of no experience: the label goes.
  void add_label(const std::string& label, const PlaceId& place);
  /// Adds an operator's word on whether two stretches are apart, in the order of revisions; `apart` is `ordered`.
  /// Part of the map while each stretch has a place in it.
  void add_apart(const Apart& apart, bool holds);
  /// Sets a rule, or takes that of its name away, in the order of revisions. Part of the map whatever its places are.
  void add_rule(const Rule& rule, bool holds);
  /// Does the same with the registration of a plan.
  void add_registration(const Registration& registration, bool holds);
  void add_damage(std::string what);

  /// Returns the network: everything that is there and was not taken out, without edges and labels of places that are
  /// not served. Experiences that were not added are as in `rest`; of those that were, every stitch has to be added,
  /// to wherever.
  Snapshot build(Revision revision, const Snapshot& rest = {});
  /// Returns what was damaged or left out, each named; complete after `build`.
  std::vector<std::string> take_damage() { return std::move(damage_); }

 private:
  struct Move {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool is_back = false;
  };
  struct Rows {
    Head head;
    std::vector<Place> places;
    std::vector<Edge> chain;
    std::vector<std::uint32_t> absent_places;
    std::vector<std::uint32_t> absent_hops;
    std::vector<Move> moves;
    std::vector<Stretch> deleted;
  };
  struct Stitch {
    std::shared_ptr<const Edge> edge;
    Revision since;
  };
  Experience assemble(Rows& rows);
  std::uint32_t measure(const Rows& rows);
  void thin(Rows& rows, std::uint32_t extent);
  void name_missing(const Rows& rows, const std::vector<bool>& out, const std::vector<bool>& there);
  bool is_out(const PlaceId& place) const;
  bool is_left_behind(const PlaceId& place) const;
  bool is_out(const EdgeId& stitch, Revision since) const;
  void borrow_neighbours(const Snapshot& rest, std::map<ExperienceId, Experience>& experiences) const;
  void join_stitches(std::map<ExperienceId, Experience>& experiences);
  std::shared_ptr<const Snapshot::Labels> labels_of(const Snapshot& network);
  std::shared_ptr<const Snapshot::Aparts> aparts_of(const Snapshot& network) const;

  std::map<ExperienceId, Rows> rows_;
  std::map<ExperienceId, std::vector<bool>> out_;  // of each index, for experiences of which something is out
  std::vector<Stitch> stitches_;
  std::map<EdgeId, Revision> stitches_out_;
  Snapshot::Labels labels_;
  std::set<Apart> aparts_;
  Snapshot::Rules rules_;
  Snapshot::Registrations registrations_;
  std::set<PlaceId> damaged_places_;
  std::vector<std::string> damage_;
};

}  // namespace weft::storage
