#pragma once
#include <filesystem>
#include <utility>

#include "core/result.hpp"

namespace weft::storage::sqlite {

/// Keeps other processes out of a directory while it lives; the system drops it when the process ends, however.
class DirectoryLock {
 public:
  /// Makes the directory if need be. unavailable: another process holds it, named by its id, or it cannot be written.
  static Result<DirectoryLock> take(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(DirectoryLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  DirectoryLock& operator=(DirectoryLock&&) = delete;

 private:
  explicit DirectoryLock(int file) : file_(file) {}
  int file_;
};

}  // namespace weft::storage::sqlite
