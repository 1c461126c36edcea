#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "server/base/request_ledger.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Holds labels that people gave to places which robots have kept and which have not come yet, as the store has them.
/// Tells those who wait for one from time to time that it still waits: a run that is refined first comes as a whole.
class AwaitedLabels {
 public:
  using Key = RequestLedger::Key;
  using Label = storage::PutAwaitedLabel;
  using Replies = std::vector<std::pair<Key, msg::OperatorReply>>;
  static constexpr std::size_t kMost = 1000;

  /// Begins with what the store has; who waits for it is told so at once.
  AwaitedLabels(const std::map<std::string, Label>& stored, SteadyTime now);

  /// Returns whether that label can wait. refused: as many as are kept wait already.
  Result<void> check_room(const std::string& label) const;
  /// Adds a label, in place of what waited under it.
  void add(Label label, SteadyTime now);
  /// Returns what waits under that label; null: nothing does.
  const Label* find(const std::string& label) const;
  /// Takes out what waits under that label; none: nothing does.
  std::optional<Label> take(const std::string& label);
  /// Notes that the places of a run from `first` on never come, and why.
  void run_ended(const PlaceId& first, const std::string& why);
  /// Notes that nothing more comes of what the robot has kept, and why.
  void robot_gone(const RobotId& robot, const std::string& why);

  struct Awaited {
    Label label;
    std::string never_comes;  ///< why; empty: it may come
    SteadyTime told_again_at;
  };
  std::vector<Awaited> all() const;

  /// Returns what to tell those who have waited for long, none of it an answer.
  Replies tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

 private:
  std::map<std::string, Awaited> awaited_;  ///< by label
};

/// Returns whom to answer about a label.
inline AwaitedLabels::Key key_of(const AwaitedLabels::Label& label) {
  return {label.asker, label.request};
}

}  // namespace weft::server
