#pragma once
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/invocation.hpp"
#include "clients/cli/layout.hpp"
#include "core/network/registration.hpp"

namespace weft::cli {

/// Holds a network moved into the frame of a registered floor plan: the part of it that the picks hold.
struct Registered {
  Window network;
  Layout layout;             ///< in the plan's frame
  std::size_t left_out = 0;  ///< places in parts without picks
  std::string caption;       ///< which plan, and how well it fits, for people
};

/// Moves a network by a registration, as the server does (core/network/site_solver.hpp). refused: nothing lies on the
/// plan; says why.
Result<Registered> registered(const Window& network, const Registration& registration);

/// Returns the name under which a plan's file is registered: that of the file without its folder and its .yaml.
std::string plan_name(const std::string& file);

/// Returns the registration of that plan; no name: the only one. not_found: there is none; refused: there are
/// several.
Result<Registration> registration_of(const std::vector<Registration>& known, const std::string& plan);

/// Returns whether a picture or a file may be wanted in the frame of a registered plan, so that it is worth asking
/// for what is registered.
bool wants_plan(const Invocation& invocation);

/// Chooses the registration in whose frame a picture or a file is wanted; none: it has a frame of its own. not_found:
/// the plan named is not registered; refused: its file or picture has changed since, or several plans are registered
/// and none is named.
Result<std::optional<Registration>> wanted_registration(const std::vector<Registration>& known,
                                                        const Invocation& invocation);

}  // namespace weft::cli
