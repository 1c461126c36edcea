#pragma once
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/network/site_solver.hpp"
#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/base/request_ledger.hpp"
#include "server/editor/editor.hpp"

namespace weft::server {

/// Registers floor plans: works out first, a piece at a time between messages, whether the picks hold the map, and
/// stores what does.
class Registering {
 public:
  using Key = RequestLedger::Key;
  using Replies = std::vector<std::pair<Key, msg::OperatorReply>>;

  Registering(Context& context, Editor& editor) : context_(context), editor_(editor) {}

  /// Begins and returns none; otherwise returns the answer that says why not.
  std::optional<msg::OperatorReply> begin(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                          Now now);
  /// Does one bounded piece; returns the answer to what is done.
  Replies tick(Now now);
  std::optional<SteadyTime> next() const { return waiting_.empty() ? std::nullopt : std::optional(next_piece_); }

 private:
  struct Waiting {
    Key key;
    msg::OperatorRequest request;
    std::string who;
    std::optional<SiteSolver> solver;  ///< none: not begun
  };
  msg::OperatorReply finish(const Waiting& asked, const SiteSolution& solution, Now now);

  Context& context_;
  Editor& editor_;
  std::deque<Waiting> waiting_;
  SteadyTime next_piece_;
};

}  // namespace weft::server
