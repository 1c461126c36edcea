#pragma once
#include <cstdint>
#include <map>
#include <utility>

#include "server/traffic/layout.hpp"

namespace weft::server {

/// Gives a second opinion on two places that may be near by the layout of their part: laid out from where one of them
/// is, the ways between the two are no longer than they have to be. In a large site of many lanes the tree of a whole
/// part has its branches part far from neighbours. Some thousand places are laid out for each stretch that is asked
/// about.
class LocalLayouts {
 public:
  /// Returns whether they are surely farther apart than that; no, when nothing is known of it.
  bool are_clear(const Snapshot& network, const PlaceId& a, const PlaceId& b, double reach_m);
  /// Takes in a batch that has joined the network: where it adds relations, the least uncertain ways may change.
  void joined(const Batch& batch);
  /// Forgets everything: the network was edited.
  void forget() { around_.clear(); }

 private:
  /// Names some consecutive places of an experience.
  using Block = std::pair<ExperienceId, std::uint32_t>;
  struct Around {
    Layout layout;
    Revision of;
  };
  const Layout& around(const Snapshot& network, const PlaceId& place, const PlaceId& other);

  std::map<Block, Around> around_;
};

}  // namespace weft::server
