#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Keeps every subscriber's window as the network has it. Sends at most two patches a second to each, and none
/// unasked while its window is right. Takes what was sent for received until the subscriber says that it holds
/// something else.
class WindowPublisher {
 public:
  explicit WindowPublisher(Context& context) : context_(context) {}

  void on_request(const msg::WindowRequest& request, SteadyTime now);
  /// Notes that the network has a new revision.
  void network_changed();
  /// Makes at most one window, for the subscriber that is due longest: messages are heard between one and the next.
  void tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

  /// Returns whether a subscriber whose window has that digest holds what the newest network has for the window that
  /// it asked for last.
  bool is_current(const PeerId& peer, const Digest& digest) const;
  std::size_t subscribers() const { return subscribers_.size(); }
  /// Returns how many of them have a window that may not be as the network has it.
  std::size_t behind() const;

 private:
  struct Subscriber {
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

  /// Returns the window as the network has it, with its digest.
  std::pair<std::shared_ptr<const Window>, Digest> window_now(const WindowDefinition& definition) const;
  /// Sends what the subscriber is due. Returns true when that took making a window, much longer than seeing that it
  /// is right.
  bool serve(const PeerId& peer, Subscriber& subscriber, SteadyTime now);
  void send(const PeerId& peer, std::uint64_t definition_id, const Patch& patch);
  /// Takes what the subscriber holds for the window with this digest; for nothing, when it cannot be told what it is.
  void assume_held(Subscriber& subscriber, Revision revision, const Digest& held_digest) const;

  Context& context_;
  std::map<PeerId, Subscriber> subscribers_;
};

}  // namespace weft::server
