#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "core/protocol/messages.hpp"

namespace weft::server {

/// Collects what the server has to say, in order. Every message but a hello gets its header here, at the moment it is
/// said: the sequence counts up in the order of sending.
class Outbox {
 public:
  Outbox(PeerId self, std::uint64_t incarnation, Epoch epoch)
      : self_(self), incarnation_(incarnation), epoch_(epoch) {}

  template <class M>
  void send(M message) {
    if constexpr (requires { message.header; }) {
      message.header = {
          .sender = self_, .incarnation = incarnation_, .epoch = epoch_, .sequence = ++sequence_, .signature = {}};
    }
    messages_.emplace_back(std::move(message));
  }

  std::vector<msg::Message> take() { return std::exchange(messages_, {}); }
  Epoch epoch() const { return epoch_; }

 private:
  PeerId self_;
  std::uint64_t incarnation_;
  Epoch epoch_;
  std::uint64_t sequence_ = 0;
  std::vector<msg::Message> messages_;
};

}  // namespace weft::server
