#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "tests/crashes/deliveries.hpp"
#include "tests/crashes/wire.hpp"

namespace weft::crashes {

/// Holds what the store has promised so far, over all rounds on one directory.
struct Promised {
  std::array<std::uint64_t, kProducers> durable_through{};
  std::uint64_t revision = 0;
  std::uint64_t floor = 0;
  std::map<std::uint64_t, Edit> edits;  ///< by revision
  bool has_snapshot = false;            ///< of the last round
  std::uint64_t snapshot_revision = 0;
};

enum class Death { killed, power };

struct RoundPlan {
  std::filesystem::path directory;
  std::filesystem::path snapshot;
  std::uint64_t seed = 0;  ///< of the deliveries
  std::uint64_t round = 0;
  Death death = Death::killed;
};

/// Runs keeper and producers until the keeper dies, at a moment drawn from seed and round; adds to what was promised.
/// Empty: it died as it should; otherwise what went wrong.
std::string run_round(const RoundPlan& plan, Promised& promised);

}  // namespace weft::crashes
