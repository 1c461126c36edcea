#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "tests/crashes/deliveries.hpp"

namespace weft::crashes {

struct KeeperPlan {
  std::filesystem::path directory;
  std::filesystem::path snapshot;  ///< where a snapshot of this round goes
  std::string vfs;
  std::uint64_t seed = 0;
};

/// Owns the store: commits what the producers hand in, answers once it is durable, and does what operators do between
/// batches: takes out, brings back, rolls back, sets labels, compacts, checks, takes a snapshot. Ends when it is
/// killed.
void keep(const KeeperPlan& plan, const std::array<int, kProducers>& producers, int watcher);

}  // namespace weft::crashes
