#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/network/routing/routing.hpp"
#include "core/network/rule_map.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Finds routes on the network as it is. It is prepared for each set of methods that robots drive with, a piece at a
/// time between messages, and kept up to date the same way; until that is done routes are found by Dijkstra.
class Routes {
 public:
  explicit Routes(Context& context) : context_(context) {}

  /// Prepares for a robot that drives with these methods. Beyond the most sets that are prepared (docs/decisions/042)
  /// it is counted.
  void want(const std::set<std::string>& methods);

  /// Finds a route as `weft::shortest_path`, of equally long ones any. When there is no way, the message may be that
  /// of a recent search for the same goal: to make one takes a search of the whole network.
  Result<Path> find(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods, SteadyTime now);
  /// Finds one that rules let a robot drive, which begins at `from`, over nothing that is closed to it; null: nothing
  /// is. not_found: there is none; names the rule.
  Result<Path> find_allowed(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods,
                            bool keeps_limits, SteadyTime now, const ClosedHops* closed = nullptr);
  /// Returns what the rules of the map come to, as it is.
  const RuleMap& rules();

  /// Does one bounded piece of work, if there is any.
  void tick(Now now);
  std::optional<SteadyTime> next() const;

  /// Returns whether routes are found over a preparation.
  bool is_prepared(const std::set<std::string>& methods) const;

 private:
  /// Holds the network made ready for one set of methods, and what is under way to make it so.
  struct Prepared {
    std::optional<routing::Preparation> ready;
    std::optional<routing::Builder> under_way;
    bool is_anew = false;  ///< what is under way does not build on what is ready
    bool is_store_read = false;
    SteadyTime next_piece;  ///< of what is under way, or the first of the next work
    Revision stored;        ///< as it was then
    SteadyTime stored_at;   ///< last tried; before that, when it was ready
  };
  using Key = std::pair<PlaceId, std::set<std::string>>;
  struct Words {
    PlaceId from;
    Error error;
    SteadyTime said_at;
  };

  bool has_work(const Prepared& prepared) const;
  bool is_behind(const Prepared& prepared) const;
  routing::Builder next_work(const std::set<std::string>& methods, Prepared& prepared);
  std::optional<routing::Builder> from_store(const std::set<std::string>& methods);
  void work(const std::set<std::string>& methods, Prepared& prepared, Now now);
  void store(const std::set<std::string>& methods, Prepared& prepared, Now now);
  std::optional<SteadyTime> storing_due(const Prepared& prepared) const;
  /// Returns when the next piece of work, or storing, is due; none: nothing is to be done.
  std::optional<SteadyTime> due(const Prepared& prepared) const;
  Error no_way(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods, SteadyTime now);

  Context& context_;
  std::map<std::set<std::string>, Prepared> prepared_;
  std::map<Key, Words> words_;
  RuleMap rules_;
  Revision rules_of_;
  Revision seen_;
  SteadyTime seen_at_;  ///< the first time
};

}  // namespace weft::server
