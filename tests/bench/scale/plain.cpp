#include "tests/bench/scale/plain.hpp"

#include <algorithm>

#include "core/network/search.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/row_reading.hpp"

namespace weft::bench {

std::uint64_t read_rows(const std::filesystem::path& store) {
  const auto database = storage::sqlite::Database::open(store / "map.sqlite", "");
  std::uint64_t bytes = 0;
  if (!database) return bytes;
  for (const char* sql : {"SELECT row FROM place", "SELECT row FROM edge"}) {
    std::ignore = storage::sqlite::for_each_row(
        *database, sql, [&](const storage::sqlite::Query& row) { bytes += row.blob(0).size(); });
  }
  return bytes;
}

PlainGraph::PlainGraph(const Snapshot& snapshot) {
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Place& place : experience->places) places_.push_back(place.id);
  }
  for (const PlaceId& place : places_) {
    first_.push_back(static_cast<std::uint32_t>(others_.size()));
    snapshot.for_each_edge(place, [&](const Edge& edge) { others_.push_back(number(other_end(edge, place))); });
  }
  first_.push_back(static_cast<std::uint32_t>(others_.size()));
  seen_.resize(places_.size());
}

std::uint32_t PlainGraph::number(const PlaceId& place) const {
  return static_cast<std::uint32_t>(std::lower_bound(places_.begin(), places_.end(), place) - places_.begin());
}

std::vector<std::uint32_t> PlainGraph::around(const PlaceId& centre, std::uint32_t hops, std::uint32_t cap) {
  ++search_;
  std::vector<std::uint32_t> found{number(centre)};
  seen_[found[0]] = search_;
  std::size_t end_of_level = 1;
  for (std::size_t at = 0; at < found.size() && found.size() < cap; ++at) {
    if (at == end_of_level) {
      if (--hops == 0) break;
      end_of_level = found.size();
    }
    for (std::uint32_t arc = first_[found[at]]; arc < first_[found[at] + 1] && found.size() < cap; ++arc) {
      if (seen_[others_[arc]] == search_) continue;
      seen_[others_[arc]] = search_;
      found.push_back(others_[arc]);
    }
  }
  return found;
}

}  // namespace weft::bench
