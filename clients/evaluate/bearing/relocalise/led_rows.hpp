#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "clients/evaluate/bearing/relocalise/led.hpp"
#include "clients/evaluate/bearing/relocalise/pairs.hpp"
#include "clients/evaluate/bearing/rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

struct LedKey {
  std::string kind;
  std::string light;
  std::uint64_t seed = 0;
  bool operator<(const LedKey& other) const {
    return std::tie(kind, light, seed) < std::tie(other.kind, other.light, other.seed);
  }
};
/// Holds what was measured.
struct LedRows {
  std::map<LedKey, std::vector<Led>> trials;                     ///< of each, in the order in which they were driven
  std::map<std::pair<std::string, std::uint64_t>, Pairs> pairs;  ///< of each hall, by what it holds and its seed
};

/// Reads DIR/relocalise.json; without the file there are no rows. conflict: it belongs to another study, which is
/// said; corrupt: it is none.
Result<LedRows> read_led(const std::filesystem::path& folder, const Study& study);
/// Writes DIR/relocalise.json, whole or not at all. unavailable: names the file.
Result<void> write_led(const std::filesystem::path& folder, const Study& study, const LedRows& rows);
/// Writes DIR/relocalise.csv, a row a trial.
Result<void> write_led_csv(const std::filesystem::path& folder, const LedRows& rows);

}  // namespace weft::evaluate::bearing
