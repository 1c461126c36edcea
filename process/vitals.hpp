#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/time.hpp"
#include "process/health_file.hpp"
#include "process/systemd.hpp"

namespace weft::process {

/// Shows to others that a process's main loop turns: to health probes by a file in its directory, to the service
/// manager by its watchdog. For the main loop's thread alone: no other thread must vouch for it.
class Vitals {
 public:
  /// Begins to start. What stands in the way of the file is said by `warn` when the process is ready, and tried again
  /// at each beat.
  Vitals(std::string program, std::filesystem::path directory, std::function<void(const std::string&)> warn,
         ServiceManager manager, SteadyTime now);

  /// Says what the process does before it is ready, for as long as it takes.
  void starting(const std::string& what, SteadyTime now);
  void ready(SteadyTime now);
  /// Returns when the next beat is due.
  SteadyTime due() const { return due_; }
  /// Says that the main loop turns. `trouble`: why it does not do its work; empty: it does.
  void beat(SteadyTime now, const std::string& trouble);
  void stopping() const { manager_.tell("STOPPING=1"); }

 private:
  void write(SteadyTime now);
  Result<void> try_to_write();

  std::filesystem::path directory_;
  std::function<void(const std::string&)> warn_;
  ServiceManager manager_;
  Duration between_;
  Health health_;
  std::optional<HealthFile> file_;
  SteadyTime due_;
  std::string told_status_;
  bool has_warned_ = false;  // since the file was written last
};

}  // namespace weft::process
