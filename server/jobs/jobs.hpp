#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/network/prune.hpp"
#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/base/request_ledger.hpp"
#include "server/editor/editor.hpp"

namespace weft::server {

/// Does long work on the map, one at a time, piece by piece between messages: check, snapshot (verified or not),
/// stats, compact, prune, replace. The asker hears how it goes twice a second. It goes on when nobody listens any
/// more, and its end is an event.
class Jobs {
 public:
  using Key = RequestLedger::Key;
  using Replies = std::vector<std::pair<Key, msg::OperatorReply>>;

  Jobs(Context& context, Editor& editor) : context_(context), editor_(editor) {}

  /// Begins a job and returns none; otherwise returns the answer that says why not.
  std::optional<msg::OperatorReply> begin(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                          Now now);
  /// Does one piece. Replies are under_way, but the last.
  Replies tick(Now now);
  /// Returns when the next piece is due: at once, while there is work.
  std::optional<SteadyTime> next() const { return running_ ? std::optional(running_->work_at) : std::nullopt; }

 private:
  struct Running {
    Key key;
    msg::OperatorRequest request;
    std::string who;
    std::unique_ptr<storage::StoreJob> store_job;  ///< this or
    std::optional<Pruner> pruner;                  ///< this
    std::string written;                           ///< of the snapshot that is being verified; empty: none is
    std::vector<std::string> findings;             ///< the first of them, for the last reply
    std::uint64_t found = 0;
    std::vector<std::string> unsaid;
    SteadyTime say_at;
    SteadyTime work_at;
  };

  Result<Running> make(const msg::OperatorRequest& request) const;
  Result<std::unique_ptr<storage::StoreJob>> store_job(const msg::OperatorRequest& request) const;
  Result<Pruner> make_pruner(const msg::OperatorRequest& request) const;
  msg::OperatorReply work_on_store(Now now);
  msg::OperatorReply verify(const storage::JobProgress& copied, msg::OperatorReply reply);
  Error unverified(const Error& error) const;
  msg::OperatorReply work_on_pruning(Now now);
  msg::OperatorReply pruned(Now now);
  void note_end(const msg::OperatorReply& reply, Now now);

  Context& context_;
  Editor& editor_;
  std::optional<Running> running_;
};

}  // namespace weft::server
