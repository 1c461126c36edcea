#pragma once
#include <memory>
#include <ostream>
#include <string>

#include "storage/map_store.hpp"

namespace weft::storage {

/// Holds one engine under the contract: a medium that outlives the stores that are opened on it.
class Medium {
 public:
  virtual ~Medium() = default;
  /// Starts a store on the medium, as a process that starts would get it. The earlier one has gone.
  virtual Result<std::unique_ptr<MapStore>> start() = 0;
  /// Starts one while an earlier store is still alive: what keeps processes apart has failed.
  virtual Result<std::unique_ptr<MapStore>> start_beside() = 0;
};

/// Tells how the contract's tests make each engine's medium.
struct Engine {
  std::string name;
  std::unique_ptr<Medium> (*make_medium)();
};
inline std::ostream& operator<<(std::ostream& out, const Engine& engine) {
  return out << engine.name;
}

std::unique_ptr<Medium> make_memory_medium();
std::unique_ptr<Medium> make_sqlite_medium();

}  // namespace weft::storage
