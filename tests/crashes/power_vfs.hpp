#pragma once
#include <cstdint>
#include <string>

namespace weft::crashes {

/// Registers a layer of SQLite over the system's files that loses power: at its `after`-th write or sync each sector
/// that was written since its file was last synchronised is kept or goes back to what it was, as `seed` says (a third
/// of the times none is kept, a third each by itself, a third all but one), and the process ends. Writes number
/// `full_from` to `full_to` fail as on a full disk. For one process, once; returns the layer's name.
struct PowerPlan {
  std::uint64_t seed = 0;
  std::uint64_t after = 0;
  std::uint64_t full_from = 0;
  std::uint64_t full_to = 0;
};
std::string register_power_vfs(const PowerPlan& plan);

}  // namespace weft::crashes
