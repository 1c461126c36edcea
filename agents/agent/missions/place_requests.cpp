#include "agents/agent/missions/place_requests.hpp"

#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kKeptAtMost = 15s;
}  // namespace

void PlaceRequests::add(const CommandKey& key, SteadyTime now) {
  keys_.push_back(key);
  until_ = now + kKeptAtMost;
}

void PlaceRequests::answer(const PlaceId& kept, Replies& replies) {
  for (const CommandKey& key : std::exchange(keys_, {})) {
    msg::AgentReply done = carried_out();
    done.place = kept;
    done.experience = kept.experience;
    replies.give(key, std::move(done));
  }
}

void PlaceRequests::refuse_all(const std::string& reason, Replies& replies) {
  for (const CommandKey& key : std::exchange(keys_, {})) replies.refuse(key, reason);
}

void PlaceRequests::tick(Replies& replies, SteadyTime now) {
  if (keys_.empty() || now < until_) return;
  refuse_all("nothing that is worth keeping was seen here for 15 s: move a little and try again", replies);
}

std::optional<SteadyTime> PlaceRequests::next() const {
  return keys_.empty() ? std::nullopt : std::optional(until_);
}

}  // namespace weft::agents
