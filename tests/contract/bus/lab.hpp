#pragma once
#include <sys/types.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "core/result.hpp"

namespace weft::contract {

/// Simulates two machines that share a cable: network namespaces with a pair of virtual Ethernet devices, gone with
/// this process however it ends. Needs root, iproute2 and nftables.
class Lab {
 public:
  enum class At : std::uint8_t { server, robot };
  static constexpr const char* kServer = "10.9.0.1";
  static constexpr const char* kRobot = "10.9.0.2";

  /// Makes a lab. unavailable: says what this machine lacks.
  static Result<std::unique_ptr<Lab>> make();
  ~Lab();
  Lab(const Lab&) = delete;
  Lab& operator=(const Lab&) = delete;

  /// Returns a process that stays in the machine's namespace.
  pid_t holder(At machine) const { return holders_[static_cast<std::size_t>(machine)]; }
  /// Runs a shell's line on one machine; its device is named `eth0`.
  Result<void> run(At machine, const std::string& line) const;
  /// Drops this share of the frames that come in, each by chance, at both ends.
  Result<void> lose(unsigned percent) const;
  /// Return the bytes that the machine's device has sent, and the IP fragments that it had to make for them.
  std::uint64_t sent_bytes(At machine) const;
  std::uint64_t fragments(At machine) const;

 private:
  Lab() = default;
  Result<void> lay_cable() const;

  std::array<pid_t, 2> holders_{};
};

}  // namespace weft::contract
