#include "idl/bus/inprocess/state.hpp"

#include <algorithm>

namespace weft::bus {
namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kInbox = 100'000;

/// Returns whether the two may exchange messages: in a star, when one of them is the server.
bool may_talk(msg::Role a, msg::Role b) {
  return (a == msg::Role::server) != (b == msg::Role::server);
}

bool loses_sent(Cut cut) {
  return cut == Cut::all || cut == Cut::sent;
}

bool loses_received(Cut cut) {
  return cut == Cut::all || cut == Cut::received;
}

}  // namespace

std::uint64_t InProcessNet::State::attach(msg::Role role, const PeerId& self) {
  detach(self);
  Endpoint& added = endpoints_[self];
  added.role = role;
  added.life = ++lives_;
  added.link = ++links_;
  for (const auto& [peer, other] : endpoints_) {
    if (may_talk(other.role, role)) send_retained(peer, self);
  }
  return added.life;
}

void InProcessNet::State::set_open(const PeerId& peer, bool is_open) {
  const auto found = endpoints_.find(peer);
  if (found == endpoints_.end() || found->second.is_open == is_open) return;
  found->second.is_open = is_open;
  if (!is_open) return;
  found->second.link = ++links_;
  std::erase_if(lanes_, [&](const auto& entry) { return entry.first.from == peer || entry.first.to == peer; });
  for (const auto& [other_id, other] : endpoints_) {
    if (!may_talk(other.role, found->second.role)) continue;
    send_retained(other_id, peer);
    send_retained(peer, other_id);
  }
}

void InProcessNet::State::detach(const PeerId& peer) {
  if (endpoints_.erase(peer) == 0) return;
  std::erase_if(retained_, [&](const auto& entry) { return entry.first.writer == peer; });
  std::erase_if(lanes_, [&](const auto& entry) { return entry.first.from == peer || entry.first.to == peer; });
}

void InProcessNet::State::partition(const PeerId& peer, Cut cut) {
  const Cut before = cut_of(peer);
  if (cut == before) return;
  cut_[peer] = cut;
  if (cut == Cut::none) cut_.erase(peer);
  const auto healed = endpoints_.find(peer);
  if (healed == endpoints_.end()) return;
  for (const auto& [other_id, other] : endpoints_) {
    if (!may_talk(other.role, healed->second.role)) continue;
    if (loses_received(before) && !loses_received(cut)) send_retained(other_id, peer);
    if (loses_sent(before) && !loses_sent(cut)) send_retained(peer, other_id);
  }
}

Cut InProcessNet::State::cut_of(const PeerId& peer) const {
  const auto found = cut_.find(peer);
  return found == cut_.end() ? Cut::none : found->second;
}

bool InProcessNet::State::passes(const PeerId& from, const PeerId& to) const {
  return !loses_sent(cut_of(from)) && !loses_received(cut_of(to));
}

Endpoint* InProcessNet::State::endpoint(const PeerId& peer, std::uint64_t life) {
  const auto found = endpoints_.find(peer);
  return found == endpoints_.end() || found->second.life != life ? nullptr : &found->second;
}

/// Returns the peer's end of a link; null when that link is closed, or another one is open.
Endpoint* InProcessNet::State::over(const PeerId& peer, std::uint64_t link) {
  const auto found = endpoints_.find(peer);
  const bool is_this = found != endpoints_.end() && found->second.is_open && found->second.link == link;
  return is_this ? &found->second : nullptr;
}

void InProcessNet::State::publish(const PeerId& from, const Topic& topic, const PeerId& to, ByteView cdr) {
  const auto bytes = std::make_shared<const Bytes>(cdr.begin(), cdr.end());
  if (topic.delivering == Delivering::state) {
    Retained slot{from, topic.id, {}};
    if (topic.keyed) std::copy_n(cdr.begin() + kEncapsulation, slot.key.size(), slot.key.begin());
    retained_[slot] = bytes;
  }
  if (topic.addressed) {
    if (endpoints_.contains(to)) send(from, to, topic, bytes);
    return;
  }
  for (const auto& [peer, other] : endpoints_) {
    if (peer != from) send(from, peer, topic, bytes);
  }
}

void InProcessNet::State::send_retained(const PeerId& writer, const PeerId& reader) {
  const auto first = retained_.lower_bound(Retained{writer, TopicId{}, {}});
  for (auto at = first; at != retained_.end() && at->first.writer == writer; ++at) {
    send(writer, reader, topic(at->first.topic), at->second);
  }
}

void InProcessNet::State::send(const PeerId& from, const PeerId& to, const Topic& topic,
                               const std::shared_ptr<const Bytes>& cdr) {
  const Endpoint& writer = endpoints_.at(from);
  const Endpoint& reader = endpoints_.at(to);
  if (!writer.is_open || !reader.is_open) return;
  if (!may_talk(writer.role, reader.role) || !topic.readers.has(reader.role)) return;
  if (!passes(from, to)) return;
  if (faults_.loss > 0.0 && random_.chance(faults_.loss)) return;
  Lane& lane = lanes_[{from, to, topic.bulk}];
  const UnderWay message{now_, 0, from, to, writer.link, reader.link, topic.id, cdr};
  put_under_way(message, lane);
  if (faults_.duplication > 0.0 && random_.chance(faults_.duplication)) put_under_way(message, lane);
}

void InProcessNet::State::put_under_way(UnderWay message, Lane& lane) {
  SteadyTime leaves = now_;
  if (faults_.bytes_per_second > 0) {
    const double needs_s = static_cast<double>(message.cdr->size()) / static_cast<double>(faults_.bytes_per_second);
    lane.busy_until = std::max(lane.busy_until, now_) + from_seconds(needs_s);
    leaves = lane.busy_until;
  }
  Duration delay = faults_.delay_min;
  if (faults_.delay_max > faults_.delay_min) {
    const auto span = static_cast<std::uint64_t>((faults_.delay_max - faults_.delay_min).count());
    delay += Duration(static_cast<Duration::rep>(random_.below(span + 1)));
  }
  message.due = leaves + delay;
  const bool free_of_order = faults_.reordering > 0.0 && random_.chance(faults_.reordering);
  if (!free_of_order) {
    message.due = std::max(message.due, lane.last_due);
    lane.last_due = message.due;
  }
  message.number = sent_++;
  under_way_.push(std::move(message));
}

std::optional<SteadyTime> InProcessNet::State::next_delivery() const {
  if (under_way_.empty()) return std::nullopt;
  return under_way_.top().due;
}

void InProcessNet::State::deliver_until(SteadyTime now) {
  set_now(now);
  while (!under_way_.empty() && under_way_.top().due <= now_) {
    deliver(under_way_.top());
    under_way_.pop();
  }
}

void InProcessNet::State::deliver(const UnderWay& message) {
  Endpoint* const reader = over(message.to, message.to_link);
  if (reader == nullptr || over(message.from, message.from_link) == nullptr) return;
  if (!passes(message.from, message.to)) return;
  if (message.cdr->size() > topic(message.topic).max_bytes) {
    ++reader->counters.refused_size;
    return;
  }
  if (reader->inbox.size() >= kInbox) {
    ++reader->counters.dropped_inbox;
    return;
  }
  ++reader->counters.received;
  reader->inbox.push_back({message.topic, *message.cdr});
}

}  // namespace weft::bus
