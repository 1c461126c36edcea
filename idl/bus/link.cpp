#include "idl/bus/link.hpp"

#include <chrono>
#include <utility>

#include "idl/bus/topics.hpp"

namespace weft::bus {
namespace {

constexpr std::size_t kTexts = 100;          ///< whole refusal texts kept until they are drained
constexpr std::size_t kReasons = 256;        ///< kinds of refusals counted apart
constexpr std::size_t kIncarnations = 4096;  ///< peers whose incarnation is remembered

/// Returns the reason without what differs from message to message: list indices and values.
std::string counted_reason(std::string_view text) {
  std::string reason;
  bool inside = false;
  for (const char c : text) {
    if (c == '[') inside = true;
    if (!inside) reason += c;
    if (c == ']') inside = false;
  }
  constexpr std::size_t kLongest = 120;
  return reason.substr(0, kLongest);
}

void count(TopicTraffic& traffic, std::size_t bytes) {
  ++traffic.messages;
  traffic.bytes += bytes;
}

}  // namespace

Link::Link(std::unique_ptr<Bus> bus) : bus_(std::move(bus)) {}

Result<std::size_t> Link::send(const msg::Message& message) {
  Result<Encoded> encoded = encode(message, bus_->role());
  if (!encoded) return fail(std::move(encoded.error()));
  if (const Result<void> sent = bus_->publish(encoded->topic, encoded->to, encoded->cdr); !sent) {
    return fail(sent.error());
  }
  count(sent_[encoded->topic], encoded->cdr.size());
  return encoded->cdr.size();
}

std::optional<msg::Message> Link::take() {
  while (std::optional<Delivery> delivery = bus_->take()) {
    Result<msg::Message> message = decode(delivery->topic, delivery->cdr);
    if (!message) {
      refuse(topic(delivery->topic).name, message.error().message, 1);
      continue;
    }
    count(received_[delivery->topic], delivery->cdr.size());
    if (const auto* const hello = std::get_if<msg::Hello>(&*message)) greet(*hello);
    return std::move(*message);
  }
  count_bus_refusals();
  return std::nullopt;
}

void Link::greet(const msg::Hello& hello) {
  if (incarnations_.size() >= kIncarnations && !incarnations_.contains(hello.peer)) incarnations_.clear();
  const auto [known, is_new] = incarnations_.try_emplace(hello.peer, hello.incarnation);
  if (is_new || known->second == hello.incarnation) return;
  // What still waits for the peer's last life is not for this one.
  bus_->forget(hello.peer);
  known->second = hello.incarnation;
}

void Link::refuse(std::string_view where, std::string_view text, std::uint64_t times) {
  std::string key = std::string(where) + ": " + counted_reason(text);
  if (refusals_.size() >= kReasons && !refusals_.contains(key)) key = "other reasons";
  refusals_[key] += times;
  if (texts_.size() < kTexts) texts_.push_back(std::string(where) + ": " + std::string(text));
}

void Link::count_bus_refusals() {
  const BusCounters now = bus_->counters();
  const auto since = [this](std::uint64_t& seen, std::uint64_t value, std::string_view text) {
    if (value > seen) refuse("bus", text, value - seen);
    seen = value;
  };
  since(seen_.refused_size, now.refused_size, "message is larger than its topic's bound");
  since(seen_.refused_vendor, now.refused_vendor, "bytes are not of the topic's type");
  since(seen_.dropped_inbox, now.dropped_inbox, "inbox is full");
}

std::vector<std::string> Link::drain_refusal_texts() {
  return std::exchange(texts_, {});
}

bool wait_until_open(Link& link, const std::function<bool()>& stop,
                     const std::function<void(const std::string&)>& tell) {
  constexpr Duration kBetween = std::chrono::milliseconds(200);
  for (;;) {
    const bool is_open = link.bus().is_open();
    for (const std::string& notice : link.bus().drain_notices()) tell(notice);
    if (is_open) return true;
    if (stop()) return false;
    link.wait(kBetween);
  }
}

}  // namespace weft::bus
