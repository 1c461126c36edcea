#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/network/apart.hpp"
#include "core/network/registration.hpp"
#include "core/network/rule.hpp"
#include "core/network/window.hpp"

namespace weft {

/// Holds a piece of the network at one revision, for a client that wants all of it: neither side has to send, or wait
/// for, more than this at once.
struct NetworkPage {
  Revision revision;
  std::vector<Place> places;                ///< in the order of their ids
  std::vector<Edge> edges;                  ///< those whose second end is one of `places`
  std::map<std::string, PlaceId> labels;    ///< all of the network's, with the last page
  std::vector<Apart> aparts;                ///< the same
  std::vector<Rule> rules;                  ///< the same
  std::vector<Registration> registrations;  ///< the same
  std::uint64_t total = 0;                  ///< places on all pages, with the first one
  bool is_last = false;
};

inline constexpr PlaceId kBehindAll{{~std::uint64_t{0}}, ~std::uint32_t{0}};

/// Returns the page that follows `after` (the first one: no place), with as many whole places and their edges as make
/// up to `entities`, and at least one place. With `other`, only experiences whose places or edges differ in the two:
/// that is the same set from either side. Behind the last place of all (`kBehindAll`) there is only what comes with
/// the last page.
NetworkPage page_of(const Snapshot& network, const Snapshot* other, const PlaceId& after, std::size_t entities);

/// Cuts a page into pieces of at most `entities` places, edges, labels, aparts, rules and registrations each; at
/// least one piece.
std::vector<NetworkPage> pieces_of(const NetworkPage& page, std::size_t entities);

/// Puts pages together again, in their order.
class PagedNetwork {
 public:
  /// Adds the next page. stale: of another revision than the first one; invalid: without a place although pages are
  /// to come, or with a place that is not after the last one.
  Result<void> add(NetworkPage page);
  bool is_whole() const { return is_whole_; }
  /// Returns the place after which the next page begins.
  PlaceId after() const {
    return window_.places.empty() ? PlaceId{} : window_.places.key_at(window_.places.size() - 1);
  }
  Revision revision() const { return window_.revision; }
  std::uint64_t done() const { return window_.places.size(); }
  std::uint64_t total() const { return total_; }
  /// Returns the window that the pages make, once it is whole. Edges that lead to places on no page are left out;
  /// labels are not. Aparts, rules and registrations are no part of a window.
  Window take();

 private:
  Window window_;
  std::vector<Edge> edges_;
  std::uint64_t total_ = 0;
  bool is_whole_ = false;
};

}  // namespace weft
