#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/by_berth.hpp"

namespace weft::server {

/// Finds robots that would come face to face: both are in a lane that is driven both ways, neither gets out of it but
/// over where the other one stands, and nobody drives backwards. Remembers what it found.
class Lanes {
 public:
  explicit Lanes(BerthGraph& graph) : graph_(graph) {}

  struct Stand {
    Berth berth = kNoBerth;
    std::uint32_t methods = 0;
    auto operator<=>(const Stand&) const = default;
  };

  /// Describes what lies ahead of a robot that stands somewhere, on a map without other robots.
  struct Ahead {
    std::size_t enough = 0;       ///< berths that it can get to when it gets away
    bool is_small = false;        ///< these are all that there are: it never gets far away from others
    std::vector<Berth> touched;   ///< on the drives to these, and as many again; sorted
    std::vector<Berth> shutting;  ///< those that shut it in: see `shut_in_by`
  };
  const Ahead& ahead(const Stand& stand);
  /// Returns the berths that shut in a robot that stands there: another one at any of them has to leave before it
  /// gets away. Sorted; empty where several ways lead on.
  const std::vector<Berth>& shut_in_by(const Stand& stand);
  /// Returns whether a robot at `by` keeps one that stands there from getting away.
  bool is_shut_in(const Stand& stand, Berth by);
  /// Returns whether robots at the two berths are face to face, or will be wherever they drive.
  bool meet(const Stand& one, const Stand& other);
  /// Returns whether the other one gets past where `here` is, or away, while a robot stands at `aside`.
  bool gets_past(const Stand& other, Berth here, Berth aside);
  bool is_beside(Berth one, Berth other);
  /// Counts searches over some berths, which bound the work of a piece.
  std::uint64_t searches() const { return searches_; }
  void clear();

 private:
  std::vector<Berth> reached(const Stand& from, Berth occupied, std::size_t most);
  std::vector<const BerthArc*> way_to(const Stand& from, Berth to);
  bool comes_round(const Stand& stand, Berth occupied);
  bool lets_pass(const Stand& one, const Stand& other);

  BerthGraph& graph_;
  std::map<Stand, Ahead> ahead_;
  std::map<Stand, std::map<Stand, bool>> meet_;  ///< of the smaller one, with the larger one
  ByBerth<std::uint32_t> seen_;                  ///< in which search
  ByBerth<Berth> from_;                          ///< the berth before it in the latest search
  std::uint32_t searches_ = 0;
};

}  // namespace weft::server
