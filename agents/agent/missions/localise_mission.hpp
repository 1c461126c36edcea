#pragma once
#include <optional>
#include <string>

#include "agents/agent/map_window.hpp"
#include "agents/agent/missions/search_policy.hpp"
#include "agents/agent/recogniser.hpp"
#include "agents/agent/replies.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Lets the robot look for itself, as an operator asks for it or of its own accord. Waits for the map first.
class LocaliseMission {
 public:
  struct Uses {
    const std::string& robot;  ///< its name
    Navigator& navigator;
    MapWindow& map;
    const Recogniser& recogniser;
    Replies& replies;
  };
  LocaliseMission(const Uses& uses, SteadyTime now) : uses_(uses), policy_(now) {}

  /// Looks around the seed, or without one in all of the map. Ends an earlier search; the caller asks for the map.
  void start(const CommandKey& asked_by, const std::optional<PlaceId>& seed, SteadyTime now);
  /// Holds all that a search of its own accord begins with.
  enum class Begun {
    nothing,  ///< none is due
    anew,     ///< it does not know where it is: the caller asks for the map
    again     ///< it goes on believing what it believes until it is seen otherwise
  };
  Begun search_if_due(const SearchPolicy::Situation& situation, SteadyTime now);
  void tick(SteadyTime now);
  /// Ends the search. Returns whether the robot had gone on believing what it believed: its route may lie elsewhere.
  bool on_fix(const Fix& fix);
  /// Forgets the search without an answer.
  void drop() { search_.reset(); }

  bool is_active() const { return search_.has_value(); }
  /// Returns whether an operator waits for the end of the search.
  bool is_asked_for() const { return search_.has_value() && search_->asked_by.has_value(); }
  bool has_seed() const { return search_.has_value() && search_->seed.has_value(); }
  /// Says how it looks for itself, for people.
  std::string describe() const;
  std::optional<SteadyTime> next() const;
  void was_away(Duration away);

 private:
  struct Search {
    std::optional<CommandKey> asked_by;  ///< none: of its own accord
    std::optional<PlaceId> seed;
    bool is_seeking = false;  ///< false: waits for the map
    bool believes = false;    ///< what it believes until it is seen otherwise
    SteadyTime deadline{};
  };
  void begin(Search search, SteadyTime now);
  void await_map(SteadyTime now);
  bool has_enough_map() const;
  bool has_nothing_to_seek() const;
  void give_up();
  void end(const std::string& refusal);

  Uses uses_;
  SearchPolicy policy_;
  std::optional<Search> search_;
};

}  // namespace weft::agents
