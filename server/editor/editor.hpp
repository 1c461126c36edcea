#pragma once
#include <set>
#include <string>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/dispatcher/dispatcher.hpp"
#include "server/editor/edits.hpp"
#include "server/traffic/traffic.hpp"

namespace weft::server {

/// Changes the map as operators ask. Each edit is one revision that can be undone; robots that drive on what is
/// edited are looked after (dispatcher/reroute.cpp, traffic).
class Editor {
 public:
  Editor(Context& context, Traffic& traffic, Dispatcher& dispatcher)
      : context_(context), traffic_(traffic), dispatcher_(dispatcher) {}

  /// Does a rollback, an undo, a quarantine, an apart, a rule, a registration, or removes or renames a label.
  msg::OperatorReply on_request(const msg::OperatorRequest& request, const std::string& who, Now now);
  /// Makes the edit. It is durable, and served, when this returns.
  msg::OperatorReply commit(const Edit& edit, const std::string& who, Now now);
  /// Returns the places that robots hold, and that routes under way and their goals need.
  std::set<PlaceId> in_use() const;
  bool holds_what_is_out() const { return traffic_.holds_what_is_out(); }
  /// Returns what the request would do to the map as it is, or why it is refused.
  Result<Edit> edit_for(const msg::OperatorRequest& request) const;

 private:
  Context& context_;
  Traffic& traffic_;
  Dispatcher& dispatcher_;
};

}  // namespace weft::server
