#pragma once
#include "server/base/clipped.hpp"
#include "server/base/config.hpp"
#include "server/base/counters.hpp"
#include "server/base/maintenance.hpp"
#include "server/base/map_writer.hpp"
#include "server/base/now.hpp"
#include "server/base/outbox.hpp"
#include "server/base/snapshots.hpp"

namespace weft::server {

/// Gives every part of the server what all of them work with. The service owns it; parts hold a reference. The map is
/// written through `writer` alone: `store` and `snapshots` are there to be read.
struct Context {
  const ServiceConfig& config;
  const storage::MapStore& store;
  Outbox& out;
  Counters& counters;
  MapWriter& writer;
  const Snapshots& snapshots;
  Maintenance& maintenance;
};

}  // namespace weft::server
