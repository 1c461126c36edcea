#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::bus {

/// Indexes the topic table (idl/bus/topics.hpp), the one place that declares names, types, QoS and directions.
enum class TopicId : std::uint8_t;

/// Holds one serialised message (XCDR1 with its encapsulation header) as it came in.
struct Delivery {
  TopicId topic{};
  Bytes cdr;
};

inline constexpr std::size_t kInboxBulkBytes = 64U << 20U;

struct BusConfig {
  msg::Role role = msg::Role::agent;  ///< which topics are written and which are read
  PeerId self;
  unsigned domain = 0;  ///< [0, 200]
  /// Names the interface to bind to, or its address; never all of them by accident. A name follows its address.
  std::string listen = "127.0.0.1";
  std::vector<std::string> servers;  ///< agents and clients: addresses of the server, HOST or HOST:INDEX
  unsigned server_index = 0;         ///< server: its fixed participant index; in use: `unavailable`
  /// Bounds the messages that wait to be taken; beyond it the oldest are dropped and counted. Bulk has a bound of its
  /// own (kInboxBulkBytes), so that small ones are never dropped for it.
  std::size_t inbox_messages = 10'000;
};

struct BusCounters {
  std::uint64_t sent = 0, received = 0, dropped_inbox = 0, refused_size = 0, refused_vendor = 0, publish_failed = 0;
  std::uint64_t peers = 0;    ///< that there are means to write to at this moment
  std::uint64_t waiting = 0;  ///< in the inbox at this moment
};

/// Sends and receives byte messages on the table's topics, in a star over DDS: the server speaks with every peer,
/// peers not with each other. Implementations deliver from threads of their own into a bounded inbox, and keep the
/// link open; everything else happens in the caller's thread. Destruction leaves the domain.
class Bus {
 public:
  virtual ~Bus() = default;
  /// Sends to everyone who reads the topic, or, on addressed topics, to `to` alone (zero: to the server).
  /// unavailable: the vendor's queue stayed full; nothing was sent, try again later.
  virtual Result<void> publish(TopicId topic, const PeerId& to, ByteView cdr) = 0;
  /// Returns the next message of others, in order of arrival; none when the inbox is empty. Never blocks.
  virtual std::optional<Delivery> take() = 0;
  /// Blocks until something can be taken, `wake()` is called or the time is over. False on time-out.
  virtual bool wait(Duration at_most) = 0;
  /// Ends a wait(). May be called from any thread or signal handler.
  virtual void wake() = 0;
  virtual std::string vendor() const = 0;
  virtual msg::Role role() const = 0;
  virtual BusCounters counters() const = 0;
  /// Drops what waits for the peer, and the means to write to it: when it has come anew or is gone for good.
  virtual void forget(const PeerId& peer) = 0;
  /// Returns false while it waits for its link or is being opened anew: publish says `unavailable` then.
  virtual bool is_open() const { return true; }
  /// Asks that the link be opened anew soon: who speaks over it is not answered, though it may hear others.
  virtual void open_anew() {}
  /// Returns what happened to its link since the last call, for the log: "waits for its link: ...".
  virtual std::vector<std::string> drain_notices() { return {}; }
};

enum class Vendor : std::uint8_t { fastdds, cyclonedds };
Result<Vendor> parse_vendor(std::string_view text);
/// Returns the version of the vendor's library that this was built with: "Fast DDS 2.9.1".
std::string library_version(Vendor vendor);
/// Opens a bus at once, or, where the interface has no carrier or no address yet, as soon as it has (see `is_open`).
/// unavailable: the participant index is in use (server), no such address, or the vendor refused; says which.
Result<std::unique_ptr<Bus>> open(Vendor vendor, const BusConfig& config);

}  // namespace weft::bus
