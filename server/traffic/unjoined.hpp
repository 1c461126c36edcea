#pragma once
#include <cstdint>
#include <string>

#include "server/base/context.hpp"
#include "server/fleet/fleet.hpp"
#include "server/traffic/traffic.hpp"

namespace weft::server {

/// Warns when robots are in parts of the map that nothing joins: traffic cannot keep these apart.
class UnjoinedWatch {
 public:
  UnjoinedWatch(Context& context, const Fleet& fleet, Traffic& traffic)
      : context_(context), fleet_(fleet), traffic_(traffic) {}

  void tick(Now now);
  /// Returns which robots, and what to do; empty: all robots are in one part.
  const std::string& warning() const { return warning_; }

 private:
  Context& context_;
  const Fleet& fleet_;
  Traffic& traffic_;
  std::uint64_t looked_ = 0;  ///< version of which robot is in which part
  std::string warning_;
};

}  // namespace weft::server
