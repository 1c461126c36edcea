#pragma once
#include <cstdint>
#include <memory>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Holds the contents that this robot has; null while the bytes have not arrived.
class Contents {
 public:
  virtual ~Contents() = default;
  virtual std::shared_ptr<const Bytes> find(const ContentHash& hash) const = 0;
};

/// Holds the robot's copy of the network, as navigation sees it for one step.
struct MapView {
  const Window& window;
  const Contents& contents;
  /// Changes whenever the window does: it can move within one revision.
  std::uint64_t generation = 0;
};

}  // namespace weft::agents
