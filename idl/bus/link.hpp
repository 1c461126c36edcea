#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/protocol/messages.hpp"
#include "idl/bus/bus.hpp"

namespace weft::bus {

/// Counts messages of one topic, and their bytes as they are serialised.
struct TopicTraffic {
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
};

/// Joins core to the wire for one process: encodes, decodes and validates (from_idl). A message that is malformed,
/// oversized or of another protocol version is refused, its reason counted; it never reaches deciding code.
class Link {
 public:
  explicit Link(std::unique_ptr<Bus> bus);

  /// Sends a message. Returns the bytes that went onto the wire.
  Result<std::size_t> send(const msg::Message& message);
  /// Returns the next valid message; none when nothing is there.
  std::optional<msg::Message> take();
  bool wait(Duration at_most) { return bus_->wait(at_most); }
  Bus& bus() { return *bus_; }
  /// Returns how often messages were refused, by "<topic>: <reason>".
  const std::map<std::string, std::uint64_t>& refusals() const { return refusals_; }
  /// Return what was sent and what came and was valid, by topic.
  const std::map<TopicId, TopicTraffic>& sent() const { return sent_; }
  const std::map<TopicId, TopicTraffic>& received() const { return received_; }
  /// Returns the last refusals with their whole text, for the log, and clears them.
  std::vector<std::string> drain_refusal_texts();

 private:
  void greet(const msg::Hello& hello);
  void refuse(std::string_view where, std::string_view text, std::uint64_t times);
  void count_bus_refusals();

  std::unique_ptr<Bus> bus_;
  BusCounters seen_;
  std::map<PeerId, std::uint64_t> incarnations_;
  std::map<std::string, std::uint64_t> refusals_;
  std::map<TopicId, TopicTraffic> sent_;
  std::map<TopicId, TopicTraffic> received_;
  std::vector<std::string> texts_;
};

/// Waits until the link is open, and tells what happens to it meanwhile. False: `stop` held first.
bool wait_until_open(Link& link, const std::function<bool()>& stop,
                     const std::function<void(const std::string&)>& tell);

/// Holds a message as it is sent. This and what follows are the link's pure halves, for golden bytes and fuzzing.
struct Encoded {
  TopicId topic{};
  PeerId to;
  Bytes cdr;
};
Result<Encoded> encode(const msg::Message& message, msg::Role sender);
/// Decodes and validates a message. invalid: names the message, the field and the bound.
Result<msg::Message> decode(TopicId topic, ByteView cdr);

}  // namespace weft::bus
