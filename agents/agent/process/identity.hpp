#pragma once
#include <filesystem>
#include <memory>

#include "core/ids.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds a robot's state directory, for one agent at a time.
class StateDirectory {
 public:
  /// Makes it if it is not there. unavailable: it cannot be made or written, or another agent works in it.
  static Result<StateDirectory> open(const std::filesystem::path& directory);
  StateDirectory(StateDirectory&& other) noexcept;
  StateDirectory& operator=(StateDirectory&&) = delete;
  ~StateDirectory();

  /// Returns the robot's id: 16 random bytes, drawn at its first start and kept in DIR/identity as 32 hex digits.
  /// corrupt: the file holds something else.
  Result<RobotId> identity() const;
  std::filesystem::path spool() const { return directory_ / "spool"; }

 private:
  StateDirectory(std::filesystem::path directory, int lock);

  std::filesystem::path directory_;
  int lock_ = -1;  // open file that holds the lock
};

/// Returns a generator seeded by the machine; differs at every call.
Random random_from_machine();

}  // namespace weft::agents
