#include "storage/map_digest.hpp"

#include <algorithm>

#include "core/byte_writer.hpp"
#include "core/network/apart.hpp"
#include "core/network/codec.hpp"

namespace weft::storage {
namespace {

std::string count_of(std::uint64_t count, const char* one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

/// Returns one experience's hash, so that the bytes of the whole map are never in memory at once.
ContentHash hash_of(const Experience& experience) {
  ByteWriter bytes;
  bytes.number(experience.id.value);
  for (const Place& place : experience.places) bytes.raw(encode(place));
  for (const Edge& hop : experience.chain) bytes.raw(encode(hop));
  for (const Edge& stitch : experience.stitches) bytes.raw(encode(stitch));
  return hash_bytes(bytes.view());
}

void put(const Stretch& stretch, ByteWriter& bytes) {
  bytes.id(PlaceId{stretch.experience, stretch.first});
  bytes.number(stretch.last);
}

}  // namespace

MapDigest digest_of(const Snapshot& snapshot) {
  MapDigest map;
  map.revision = snapshot.revision();
  map.experiences = snapshot.experience_count();
  map.places = snapshot.place_count();
  map.edges = snapshot.stitch_count();
  map.labels = snapshot.labels().size();
  map.aparts = snapshot.aparts().size();
  map.rules = snapshot.rules().size();
  map.registrations = snapshot.registrations().size();
  ByteWriter bytes;
  for (const auto& [id, experience] : snapshot.experiences()) {
    map.edges += experience->chain.size();
    if (!experience->places.empty()) bytes.id(hash_of(*experience));
  }
  for (const auto& [label, place] : snapshot.labels()) {
    bytes.text(label);
    bytes.id(place);
  }
  for (const Apart& apart : snapshot.aparts()) {
    put(apart.one, bytes);
    put(apart.other, bytes);
  }
  for (const auto& [name, rule] : snapshot.rules()) bytes.raw(encode(rule));
  for (const auto& [plan, registration] : snapshot.registrations()) bytes.raw(encode(registration));
  const ContentHash hash = hash_bytes(bytes.view());
  std::ranges::copy(hash.bytes, map.digest.bytes.begin());
  return map;
}

std::string to_text(const MapDigest& map) {
  return count_of(map.experiences, "experience") + ", " + count_of(map.places, "place") + ", " +
         count_of(map.edges, "edge") + ", " + count_of(map.labels, "label") + ", " + count_of(map.rules, "rule") +
         ", " + count_of(map.registrations, "registration") + " and " + count_of(map.aparts, "pair") +
         " of stretches apart";
}

}  // namespace weft::storage
