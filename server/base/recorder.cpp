#include "server/base/recorder.hpp"

#include <utility>
#include <variant>
#include <vector>

namespace weft::server {
namespace {
constexpr std::size_t kLongestText = 2000;
}

std::string clipped(std::string text) {
  if (text.size() > kLongestText) text.resize(kLongestText);
  return text;
}

Result<Revision> Recorder::commit(storage::Transaction transaction, Now now) {
  if (broken_) return fail(*broken_);
  std::vector<msg::Event> events;
  for (auto& change : transaction.changes) {
    if (auto* const put = std::get_if<storage::PutEvent>(&change)) {
      put->event.at = now.wall;
      put->event.cause = clipped(std::move(put->event.cause));
      events.push_back(put->event);
    }
  }
  transaction.note.at = now.wall;
  const Result<storage::Commit> done = store_.commit(transaction);
  if (!done) {
    failed(done.error(), now);
    return fail(done.error());
  }
  for (const msg::Event& event : events) tell(event);
  if (stopped_) {
    stopped_.reset();
    note({.at = {},
          .kind = "store.works_again",
          .robot = {},
          .goal = {},
          .cause = "a write succeeded",
          .who = "server"},
         now);
  }
  return done->revision;
}

void Recorder::note(msg::Event event, Now now) {
  event.at = now.wall;
  event.cause = clipped(std::move(event.cause));
  const Result<storage::Commit> kept =
      broken_ ? Result<storage::Commit>(fail(*broken_)) : store_.commit({{storage::PutEvent{event}}});
  if (!kept) {
    ++counters_["store: event told but not kept"];
    failed(kept.error(), now);
  }
  tell(event);
}

void Recorder::failed(const Error& error, Now now) {
  ++counters_[std::string("store: ") + to_string(error.code)];
  // A conflict is about the transaction, not about the store.
  if (error.code == ErrorCode::conflict || error.code == ErrorCode::invalid) return;
  const bool is_new = !stopped_.has_value();
  stopped_ = error;
  if (error.code == ErrorCode::stale) broken_ = error;
  if (is_new) {
    tell({.at = now.wall, .kind = "store.stopped", .robot = {}, .goal = {}, .cause = error.message, .who = "server"});
  }
}

}  // namespace weft::server
