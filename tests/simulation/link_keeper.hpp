#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "idl/bus/inprocess/net.hpp"
#include "idl/bus/keeping.hpp"

namespace weft::simulation {

/// Tells where a process is on the network, and where its server's name leads.
struct Whereabouts {
  std::string own;
  std::string server;  ///< empty: it is the server
  bool operator==(const Whereabouts&) const = default;
};

/// Keeps one process's link on the simulated network open, as the product does over DDS: its `bus::Keeping` decides
/// when the server's name is resolved anew, and when the link is closed and opened anew. Addresses are below the
/// simulated network; a link knows which ones it was opened for, and connects as long as they hold.
class LinkKeeper {
 public:
  /// Begins with a link that is open, the server's name resolved.
  LinkKeeper(bus::InProcessNet& net, const PeerId& self, Whereabouts now_at, SteadyTime now);

  /// Looks at the link as the keeper's thread does twice a second. `received`: messages since the process began;
  /// `unseen`: how long the process stood still since the last look.
  void look(const Whereabouts& now_at, SteadyTime now, std::uint64_t received, Duration unseen);
  /// Returns whether the link is open for where both ends are.
  bool connects(const Whereabouts& now_at) const { return opened_for_ == now_at; }

 private:
  void open(const Whereabouts& now_at, SteadyTime now);
  void resolve(const Whereabouts& now_at);

  bus::InProcessNet* net_;
  PeerId self_;
  bus::Keeping keeping_{"simulated"};
  std::vector<bus::ServerAddress> servers_;
  bool has_asked_ = false;                 ///< the resolver; its answer is there at the next look
  std::optional<Whereabouts> opened_for_;  ///< none: it is closed
};

}  // namespace weft::simulation
