#pragma once
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Moves what a store's log has into its file, on a thread and a connection of its own: SQLite would have a commit in
/// twenty do it, and everybody wait for that one.
class Checkpointer {
 public:
  static Result<std::unique_ptr<Checkpointer>> start(const std::filesystem::path& file, const std::string& vfs);
  ~Checkpointer();
  Checkpointer(const Checkpointer&) = delete;
  Checkpointer& operator=(const Checkpointer&) = delete;

  /// Tells the checkpointer how many pages the log has; called by the connection that commits. True: it is better
  /// emptied at once, because this thread does not keep up, or cannot write.
  bool log_has(std::uint64_t pages);

 private:
  explicit Checkpointer(Database database);
  void work();

  Database database_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_wanted_ = false;
  bool is_over_ = false;
  std::thread thread_;  // last: it begins when all the others are there
};

}  // namespace weft::storage::sqlite
