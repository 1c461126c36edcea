#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/time.hpp"
#include "server/base/request_ledger.hpp"

namespace weft::server {

/// Holds labels that people gave to places which robots have kept and which the server does not have yet. Tells the
/// clients that wait for one so from time to time: a run that is refined first comes as a whole, once it is refined.
class AwaitedLabels {
 public:
  using Key = RequestLedger::Key;
  struct Label {
    Key key;
    std::string label;
    std::string who;
  };
  using Replies = std::vector<std::pair<Key, msg::OperatorReply>>;

  void add(const PlaceId& place, Label label, SteadyTime now);
  /// Takes out all that wait for a place.
  std::vector<Label> take(const PlaceId& place);

  /// Returns what to tell those who have waited for long, none of it an answer.
  Replies tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

 private:
  struct Awaited {
    Label label;
    SteadyTime told_again_at;
  };
  std::multimap<PlaceId, Awaited> awaited_;
};

}  // namespace weft::server
