#pragma once
#include <cstddef>

#include "core/network/routing/preparation.hpp"

namespace weft::routing {

/// Does the work of a builder, piece by piece. Private to the routing folder.
class Work {
 public:
  virtual ~Work() = default;
  /// Does one indivisible piece; returns how many places' worth it was, 0 when nothing is left.
  virtual std::size_t piece() = 0;
  /// Returns the share of the work that is done, [0, 1].
  virtual double share_done() const = 0;
  /// Gives the preparation away, once, when nothing is left.
  virtual Preparation take() = 0;
};

}  // namespace weft::routing
