#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/network/network.hpp"

/// Holds what the server's start and its windows are measured beside.
namespace weft::bench {

/// Steps through the stored rows of places and edges, and looks at none. Returns their bytes.
std::uint64_t read_rows(const std::filesystem::path& store);

/// Holds the network as rows of numbers, and searches it breadth-first for nothing but the numbers that it finds.
class PlainGraph {
 public:
  explicit PlainGraph(const Snapshot& snapshot);
  /// Returns at most `cap` places within `hops`, in the order in which they are found.
  std::vector<std::uint32_t> around(const PlaceId& centre, std::uint32_t hops, std::uint32_t cap);

 private:
  std::uint32_t number(const PlaceId& place) const;

  std::vector<PlaceId> places_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> others_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t search_ = 0;
};

}  // namespace weft::bench
