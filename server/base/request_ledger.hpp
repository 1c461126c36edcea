#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include "core/protocol/messages.hpp"

namespace weft::server {

/// Remembers which requests were answered how, so that a repeat is done once and answered alike. Keeps the latest
/// 4096.
class RequestLedger {
 public:
  using Key = std::pair<PeerId, std::uint64_t>;  ///< who asked, and the number that it gave
  enum class Seen : std::uint8_t { fresh, under_way, answered };

  Seen see(const Key& key) {
    const auto found = replies_.find(key);
    if (found != replies_.end()) return found->second ? Seen::answered : Seen::under_way;
    replies_.emplace(key, std::nullopt);
    order_.push_back(key);
    if (order_.size() > kRemembered) {
      replies_.erase(order_.front());
      order_.pop_front();
    }
    return Seen::fresh;
  }
  const msg::OperatorReply& answer(const Key& key) const { return *replies_.at(key); }
  void answered(const Key& key, const msg::OperatorReply& reply) {
    const auto found = replies_.find(key);
    if (found != replies_.end()) found->second = reply;
  }

 private:
  static constexpr std::size_t kRemembered = 4096;
  std::map<Key, std::optional<msg::OperatorReply>> replies_;
  std::deque<Key> order_;
};

}  // namespace weft::server
