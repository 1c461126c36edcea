#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/time.hpp"

/// Holds how peers greet each other and compare clocks, and what stands in every message.
namespace weft::msg {

inline constexpr std::uint16_t kProtocolVersion = 1;

/// Says who speaks, and under which server's authority; stands in every message that claims authority.
struct Header {
  PeerId sender;
  std::uint64_t incarnation = 0;  ///< random at each start of the sender: two live ones of one id raise an alarm
  Epoch epoch;                    ///< the server's, as the sender knows it; 0 before the first hello
  std::uint64_t sequence = 0;     ///< counts this sender's messages of this incarnation
  Bytes signature;                ///< room for one; empty today, at most 64 bytes
};

enum class Role : std::uint8_t { server = 1, agent = 2, client = 3 };

/// Tells what came of a request. under_way: long work has come so far; another reply follows.
enum class Outcome : std::uint8_t { done = 1, accepted = 2, refused = 3, failed = 4, under_way = 5 };

inline constexpr std::size_t kAnswers = 32;  ///< challenges in a server's hello

/// Introduces a peer. Frozen for ever: every version can read it. Late joiners get the last one of each peer.
struct Hello {
  PeerId peer;
  std::uint64_t incarnation = 0;
  Role role = Role::agent;
  std::uint16_t protocol_min = kProtocolVersion;
  std::uint16_t protocol_max = kProtocolVersion;
  Epoch epoch;  ///< a server's own; 0 from others
  std::string name;
  std::string software;  ///< version for people
  std::string vendor;    ///< fastdds | cyclonedds | inprocess, as the bus names itself
  /// Asks the server to prove that it lives: random, to be repeated in its next hello. Agents and clients set it; 0:
  /// none.
  std::uint64_t challenge = 0;
  /// Repeats the challenges last heard, at most kAnswers; a server's only. Proves that it lives, and hears the asker.
  std::vector<std::uint64_t> answers{};
};

inline constexpr std::size_t kEchoBytes = 16'384;

/// Comes back from the server as it is, within its bounds: measures the network between a client and the server. It
/// is not sent again when it is lost.
struct Echo {
  Header header;
  PeerId to;  ///< none: to the server
  std::uint64_t request = 0;
  std::uint32_t number = 0;  ///< of those of one request
  Bytes load;                ///< at most kEchoBytes
};

struct ClockProbe {
  Header header;
  PeerId to;
  std::uint64_t probe = 0;
  WallTime sent{};
};
struct ClockReply {
  Header header;
  std::uint64_t probe = 0;
  WallTime probe_sent{};
  WallTime received{};
  WallTime replied{};
};

}  // namespace weft::msg
