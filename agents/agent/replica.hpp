#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/agent/session.hpp"
#include "core/network/window.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Holds the robot's copy of its window of the network. Patches are put together from their parts and applied; one
/// that does not fit, or that gives another digest than the server's, changes nothing and leads to a new request.
class Replica {
 public:
  /// Begins with `first_id`, random for each incarnation, so that answers to an earlier one are not taken for ours.
  Replica(WindowDefinition definition, std::uint64_t first_id, SteadyTime now);

  /// Asks for another part of the network from now on. The same definition as before does nothing.
  void define(WindowDefinition definition, SteadyTime now);
  const WindowDefinition& definition() const { return definition_; }

  /// Returns whether the patch answers a request of this incarnation.
  bool is_own(const msg::WindowPatch& part) const {
    return part.definition_id >= first_id_ && part.definition_id <= definition_id_;
  }
  enum class Heard { changed, incomplete, ignored };
  Heard on_patch(const msg::WindowPatch& part, SteadyTime now);
  /// Asks again: the server may have forgotten who holds what.
  void server_restarted(SteadyTime now);

  /// Returns a request without its header, when it is time for one.
  std::optional<msg::WindowRequest> due(SteadyTime now);
  SteadyTime next() const { return ask_at_; }

  const Window& window() const { return window_; }
  /// Returns the window as it was before the last change.
  const Window& before() const { return before_; }
  const Digest& digest() const { return digest_; }
  /// Returns another number after each change of the window, which can move within one revision.
  std::uint64_t generation() const { return generation_; }
  /// Returns whether the window is of the present definition; false until its first patch has come.
  bool is_settled() const { return held_id_ == definition_id_; }
  const Counters& counters() const { return counters_; }

 private:
  struct Parts {
    Revision base;
    Revision target;
    Digest digest;
    std::vector<std::optional<Patch>> parts;
  };
  std::optional<Patch> join(const msg::WindowPatch& part);
  void ask(SteadyTime now);

  WindowDefinition definition_;
  std::uint64_t first_id_;
  std::uint64_t definition_id_;
  std::uint64_t held_id_ = 0;  ///< the definition that the window is of
  Window window_;
  Window before_;
  Digest digest_;
  std::uint64_t generation_ = 0;
  bool fresh_ = false;  ///< what is held is of no use as a base
  std::optional<Parts> parts_;
  SteadyTime ask_at_;
  SteadyTime asked_at_;
  Duration wait_;
  Counters counters_;
};

}  // namespace weft::agents
