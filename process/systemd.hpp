#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/time.hpp"

namespace weft::process {

/// Returns how often at least the service manager wants to hear of the process: WATCHDOG_USEC, when WATCHDOG_PID is
/// not given or is the process's own. Zero: not at all.
Duration watchdog_of(const char* microseconds, const char* process, std::int64_t self);

/// Tells the service manager (systemd) about this process, by datagrams to its socket; does nothing without one.
/// Never blocks, and what cannot be sent is dropped.
class ServiceManager {
 public:
  /// Takes NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID of the environment.
  static ServiceManager of_environment();
  /// `socket`: its path, or an abstract name that begins with '@'; empty: there is none.
  ServiceManager(std::string socket, Duration watchdog);

  /// Sends lines of NAME=VALUE, as sd_notify(3) lists them.
  void tell(std::string_view state) const;
  /// Returns after how long without WATCHDOG=1 it ends the process; zero: never.
  Duration watchdog() const { return watchdog_; }

 private:
  std::string socket_;
  Duration watchdog_;
};

}  // namespace weft::process
