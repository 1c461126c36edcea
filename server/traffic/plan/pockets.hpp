#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"
#include "server/traffic/plan/distances.hpp"

namespace weft::server {

/// Describes berths that can only be left past one of them, the mouth: two robots cannot pass each other in there,
/// or only at the end of it.
struct Pocket {
  Berth exit = kNoBerth;  ///< the berth at the mouth to which robots drive out
  std::vector<Berth>
      at_mouth;  ///< berths at which a robot stands in the mouth: the one there and those beside it, sorted
  std::vector<Berth> inside;  ///< sorted; without the mouth
};

/// Finds pockets around berths as they are asked for: places to which robots go, or where they stand.
class Pockets {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  explicit Pockets(BerthGraph& graph) : graph_(graph) {}

  /// Looks at so many more of the berths around at most, so that `look` finds what leads from one to the other looked
  /// up. Returns whether all are. One berth after the other: what was begun for another one is forgotten.
  bool look_around(Berth berth, std::uint32_t methods, std::size_t most);
  /// Looks for the pocket in which the berth lies, once; drives of `methods` join berths, either way round.
  std::uint32_t look(Berth berth, std::uint32_t methods);
  /// Returns the pocket that is known to hold the berth.
  std::uint32_t of(Berth berth) const;
  bool is_at_mouth(std::uint32_t pocket, Berth berth) const;
  const std::vector<Berth>& at_mouth(std::uint32_t pocket) const { return pockets_[pocket].at_mouth; }
  /// Returns whether all drives from the berth lead into the pocket.
  bool leads_only_into(std::uint32_t pocket, Berth from, std::uint32_t methods) const;
  /// Tells how far it is out to the mouth.
  Distances& to_mouth(std::uint32_t pocket, std::uint32_t methods);
  std::size_t size() const { return pockets_.size(); }
  void clear();

 private:
  /// Holds the berths around one as far as they have been looked at: from the first to before `next`.
  struct Around {
    std::vector<Berth> reached;
    std::set<Berth> seen;
    std::uint32_t methods = 0;
    std::size_t next = 0;
  };

  BerthGraph& graph_;
  const std::vector<Berth> nothing_;
  Around around_;
  std::vector<Pocket> pockets_;
  std::map<Berth, std::uint32_t> of_;  ///< `kNone`: looked for, and there is none
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::unique_ptr<Distances>> to_mouth_;
};

/// Returns the largest pocket that holds the berth, as far as some 200 berths around show it.
std::optional<Pocket> pocket_around(BerthGraph& graph, Berth berth, std::uint32_t methods);

}  // namespace weft::server
