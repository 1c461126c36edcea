#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/network/apart.hpp"
#include "core/network/registration.hpp"
#include "core/network/removal.hpp"
#include "core/network/rule.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Holds what an operator's edit would do to the map as it is.
struct Edit {
  Removal out;
  Removal back;
  std::vector<Place> known_anew;                                     ///< places as they are known from now on
  std::map<std::string, PlaceId> labels;                             ///< a place of no experience: the label goes
  std::map<Apart, bool> aparts;                                      ///< false: vouched for no longer
  std::map<std::string, std::optional<Rule>> rules;                  ///< none: the rule goes
  std::map<std::string, std::optional<Registration>> registrations;  ///< by plan; none: it goes
  Revision to;                                                       ///< not 0: a rollback, and nothing else
  std::string kind;                                                  ///< for the log
  std::string cause;                                                 ///< what was asked for, in words
  bool empty() const {
    return out.empty() && back.empty() && known_anew.empty() && labels.empty() && aparts.empty() && rules.empty() &&
           registrations.empty() && to.value == 0;
  }
};

/// Says it for people: "12 places and 3 stitches leave the map".
std::string to_text(const Edit& edit);

/// Returns the experiences of that name: one, or all that one import made of its file. When none has it, returns the
/// one whose hex id begins so, with four digits or more. not_found; refused: several taught ones have the name, or
/// ids begin so, with their ids.
Result<std::vector<ExperienceId>> experiences_of(const Snapshot& snapshot, const std::string& name);
/// Returns the one experience of that name. refused: several.
Result<ExperienceId> experience_of(const Snapshot& snapshot, const std::string& name);

// Each is not_found when nothing of it is left to do, and says so.

/// Takes out the places and stitches named, or a whole experience by its name.
Result<Edit> taking_out(const Snapshot& snapshot, const msg::OperatorRequest& request);
/// Vouches that the two stretches named are different floors. invalid: not two, or stretches that cannot be;
/// conflict: they are so already.
Result<Edit> setting_apart(const Snapshot& snapshot, const msg::OperatorRequest& request);
Result<Edit> removing_label(const Snapshot& snapshot, const std::string& label);
/// Renames a label. conflict: the new one is a label already.
Result<Edit> renaming_label(const Snapshot& snapshot, const std::string& label, const std::string& new_label);
/// Lays a rule down, in the place of one of its name. Errors as `check`; conflict: it is so already.
Result<Edit> putting_rule(const Snapshot& snapshot, const Rule& rule);
Result<Edit> removing_rule(const Snapshot& snapshot, const std::string& name);
/// Returns the rule that holds robots on the places of the rule of that name, until it is removed.
Result<Edit> holding_places_of(const Snapshot& snapshot, const std::string& name);
Result<Edit> freeing_places_of(const Snapshot& snapshot, const std::string& name);
/// Registers a floor plan, in the place of a registration of its name. Errors as `check`; conflict: it is so already.
Result<Edit> putting_registration(const Snapshot& snapshot, const Registration& registration);
/// Removes the registration of a plan; no name: of the only one. refused: there are several.
Result<Edit> removing_registration(const Snapshot& snapshot, const std::string& plan);
/// Turns round what a revision changed. refused: a rollback that is not the newest revision, or a plan that would
/// come back to a map that has as many as it may.
Result<Edit> undoing(const Snapshot& snapshot, const storage::MapStore& store, Revision revision);
Result<Edit> rolling_back(const Snapshot& snapshot, const storage::MapStore& store, Revision to);

}  // namespace weft::server
