#pragma once
#include <filesystem>
#include <string_view>

#include "core/result.hpp"
#include "core/time.hpp"
#include "process/health.hpp"

namespace weft::process {

/// Holds DIR/health, in which a running process says how it is. A lock on it lives as long as the process does,
/// however it ends: what a dead one has left there does not count. The record is overwritten in place and not synced,
/// so it needs no room on a full disk and delays no commit.
class HealthFile {
 public:
  /// Opens or makes the file, and locks it. unavailable: it cannot be written, or another process has it.
  static Result<HealthFile> open(const std::filesystem::path& directory);
  HealthFile(HealthFile&& other) noexcept;
  HealthFile& operator=(HealthFile&& other) noexcept;
  ~HealthFile();

  /// Overwrites the record. exhausted: there is no room; unavailable: the file was removed, or cannot be written.
  Result<void> write(const Health& health);

 private:
  explicit HealthFile(int file) : file_(file) {}

  int file_ = -1;  // open file that holds the lock
};

/// Looks how the process is that works in the directory. Takes no lock, sends nothing, and needs only the right to
/// read.
Verdict look_at_health(const std::filesystem::path& directory, SteadyTime now);

/// Prints one line on how the process is that works in the directory, and returns the exit code: 0 healthy, 1 not.
int report_health(std::string_view program, const std::filesystem::path& directory);

}  // namespace weft::process
