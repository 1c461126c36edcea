#pragma once
#include <cstdint>
#include <string>

#include "core/network/network.hpp"

namespace weft::storage {

/// Holds the digest by which two maps that should be one are compared: counts for people, and a hash over all of it.
struct MapDigest {
  Revision revision;
  std::uint64_t experiences = 0, places = 0, edges = 0, labels = 0, aparts = 0, rules = 0;
  std::uint64_t registrations = 0;
  Digest
      digest;  ///< SHA-256 over the canonical bytes of places and edges, then labels, aparts, rules and registrations
  bool operator==(const MapDigest&) const = default;
};
MapDigest digest_of(const Snapshot& snapshot);

/// Returns "12 places, 11 edges, ...".
std::string to_text(const MapDigest& map);

}  // namespace weft::storage
