#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/network/change.hpp"
#include "core/network/network.hpp"

namespace weft::storage {

/// Makes a snapshot of stored rows in linear time (joining batches one by one would copy each experience again and
/// again). What is damaged or missing is left out and named, the rest is served.
class NetworkBuilder {
 public:
  /// An experience's row: everything but its places and edges.
  struct Head {
    ExperienceId id;
    RobotId robot;
    std::string name{};
    std::string method{};
    bool sealed = false;
    std::string seal_reason{};
    std::uint64_t places = 0;  ///< how many rows there must be
  };

  void add(Head head);
  /// In any order. An edge that is added again replaces the earlier one.
  void add(Place place);
  void add(Edge edge);
  void add_label(const std::string& label, const PlaceId& place);
  void add_damage(std::string what);

  /// An experience is served up to its first place, or odometry edge, that is not there; stitches and labels of
  /// places that are not served are left out.
  Snapshot build(Revision revision);
  /// What was damaged or left out, each named; complete after `build`.
  std::vector<std::string> take_damage() { return std::move(damage_); }

 private:
  struct Rows {
    Head head;
    std::vector<Place> places;
    std::vector<Edge> chain;
  };
  Experience assemble(Rows& rows);
  void join_stitches(std::map<ExperienceId, Experience>& experiences);

  std::map<ExperienceId, Rows> rows_;
  std::vector<Edge> stitches_;
  Snapshot::Labels labels_;
  std::vector<std::string> damage_;
};

}  // namespace weft::storage
