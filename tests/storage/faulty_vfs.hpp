#pragma once
#include <string>

namespace weft::storage {

/// Puts faults into SQLite's own file layer, for one test at a time: SQLite keeps layers by name for the whole
/// process.
class FaultyVfs {
 public:
  enum class Fault { none, disk_full, io_error };

  FaultyVfs();
  ~FaultyVfs();
  FaultyVfs(const FaultyVfs&) = delete;
  FaultyVfs& operator=(const FaultyVfs&) = delete;

  const std::string& name() const;
  /// Lets `writes` more writes or syncs succeed, then fails all.
  void fail_after(int writes, Fault fault);
  void heal() { fail_after(0, Fault::none); }
  /// Returns the number of writes and syncs since the last call.
  int take_count();
};

}  // namespace weft::storage
