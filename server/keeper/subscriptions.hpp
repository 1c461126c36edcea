#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Keeps every asker's window as the network has it. At most two patches a second for each asker; none unasked while
/// its window is right. What was sent is taken for received until the asker says that it holds something else.
class Subscriptions {
 public:
  explicit Subscriptions(Context& context) : context_(context) {}

  void on_request(const msg::WindowRequest& request, SteadyTime now);
  /// The network has a new revision.
  void network_changed();
  /// Makes at most one window, for whom is due longest: messages are heard between one and the next.
  void tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

 private:
  struct Asker {
    std::uint64_t definition_id = 0;
    WindowDefinition definition;
    std::shared_ptr<const Window> held;  ///< as far as we know; null: nothing, or nothing we can build on
    std::shared_ptr<const Snapshot> of;  ///< in which `held` is the window of `held_definition`
    WindowDefinition held_definition;
    Digest held_digest;
    SteadyTime next_patch;  ///< not earlier
    bool behind = true;     ///< its window may have changed
    bool asked = true;      ///< it asked, and has no answer yet
  };

  /// As the network has it, with its digest.
  std::pair<std::shared_ptr<const Window>, Digest> window_now(const WindowDefinition& definition) const;
  /// True when that took making a window, much longer than seeing that it is right.
  bool serve(const PeerId& peer, Asker& asker, SteadyTime now);
  void send(const PeerId& peer, std::uint64_t definition_id, const Patch& patch);
  /// Takes what the asker holds for the window with this digest; for nothing, when we cannot tell what it is.
  void believe(Asker& asker, Revision revision, const Digest& held_digest) const;

  Context& context_;
  std::map<PeerId, Asker> askers_;
};

}  // namespace weft::server
