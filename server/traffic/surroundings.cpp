#include "server/traffic/surroundings.hpp"

#include <memory>

namespace weft::server {
namespace {

constexpr std::uint32_t kPlacesOfBlock = 32;
constexpr std::size_t kPlacesAround = 3000;
constexpr std::size_t kMostBlocks = 64;

}  // namespace

/// Made anew when the network has grown since by what is asked about.
const Layout& Surroundings::around(const Snapshot& network, const PlaceId& place, const PlaceId& other) {
  const Block block{place.experience, place.index / kPlacesOfBlock};
  const auto known = around_.find(block);
  if (known != around_.end()) {
    const bool has_both = known->second.layout.spot(place) && known->second.layout.spot(other);
    if (has_both || known->second.of == network.revision()) return known->second.layout;
    around_.erase(known);
  }
  if (around_.size() >= kMostBlocks) around_.clear();
  Around& made = around_[block];
  made.of = network.revision();
  // Looked at now alone: it does not outlive the call.
  made.layout.lay_around(Layout::Network(Layout::Network(), &network), place, kPlacesAround);
  return made.layout;
}

bool Surroundings::are_clear(const Snapshot& network, const PlaceId& a, const PlaceId& b, double reach_m) {
  const Layout& layout = around(network, b, a);
  const std::optional<Spot> of_a = layout.spot(a);
  const std::optional<Spot> of_b = layout.spot(b);
  return of_a && of_b && !layout.are_near(*of_a, *of_b, reach_m);
}

}  // namespace weft::server
