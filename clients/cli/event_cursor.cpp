#include "clients/cli/event_cursor.hpp"

#include <algorithm>
#include <utility>

namespace weft::cli {

EventCursor::Taken EventCursor::take(msg::QueryReply reply, std::size_t most) {
  Taken taken;
  if (reply.newest_event < after_) {
    taken.lost = "the server has another store, whose last event is number " + std::to_string(reply.newest_event) +
                 " and not " + std::to_string(after_) + ": what it holds since its snapshot may be missing here";
    after_ = reply.newest_event;
    return taken;
  }
  if (after_ > 0 && reply.oldest_event > after_ + 1) {
    taken.lost = "events " + std::to_string(after_ + 1) + " to " + std::to_string(reply.oldest_event - 1) +
                 " are not kept any more";
  }
  taken.is_all = reply.events.size() < most;
  for (msg::Event& event : reply.events) {
    if (event.number <= after_) continue;
    after_ = event.number;
    taken.events.push_back(std::move(event));
  }
  if (taken.is_all) after_ = std::max(after_, reply.newest_event);
  return taken;
}

}  // namespace weft::cli
