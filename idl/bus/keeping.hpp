#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "idl/bus/addresses.hpp"
#include "idl/bus/interfaces.hpp"

namespace weft::bus {

/// Holds everything that decides when a bus is opened and closed, as it is at one moment.
struct Sight {
  SteadyTime now{};
  std::uint64_t received = 0;  ///< messages since the process began
  LocalLink link;              ///< of the interface that is listened on
  /// Says where the servers' names lead by the last answer of the resolver; none: it has not answered.
  std::optional<std::vector<ServerAddress>> servers;
  bool is_unanswered = false;  ///< who speaks over the bus says so, since the last look
  Duration unseen{};           ///< since the last look, as far as it passed while nothing was being done
};

/// Decides when a process joins its DDS domain and when it leaves it to join anew: vendors bind to addresses once,
/// and hear nothing when the interface was not running then, when its address has changed, or when the server has
/// moved. A state machine without clock and sockets.
class Keeping {
 public:
  enum class Step : std::uint8_t { stay, join, leave };
  struct Decision {
    Step step = Step::stay;
    bool asks_resolver = false;  ///< for the servers' addresses
    std::string notice;          ///< for the log; empty: none
  };

  /// Starts outside the domain. `listen`: the address or interface as configured, for notices only.
  explicit Keeping(std::string listen) : listen_(std::move(listen)) {}

  Decision next(const Sight& sight);
  /// Takes note that joining succeeded. Returns a notice when people were told that the link was not open.
  std::string joined(SteadyTime now, const Addresses& at);
  void failed(SteadyTime now, const std::string& why);

 private:
  Decision outside(const Sight& sight);
  Decision inside(const Sight& sight);
  Decision leave(SteadyTime now, std::string why);
  /// Returns the text when it is new or has not been said for long, else nothing: so that logs do not fill.
  std::string said(SteadyTime now, std::string text);

  std::string listen_;
  std::optional<Addresses> at_;  ///< none: outside the domain
  SteadyTime joined_at_{};
  SteadyTime join_at_{};
  std::uint64_t received_ = 0;
  SteadyTime heard_at_{};
  Duration patience_{};
  std::optional<SteadyTime> changed_since_;
  SteadyTime ask_at_{};
  std::string why_not_;  ///< it could not join when it tried last
  std::string said_;     ///< since it is outside
  SteadyTime say_at_{};
};

}  // namespace weft::bus
