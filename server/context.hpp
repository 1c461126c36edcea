#pragma once
#include "core/random.hpp"
#include "server/keeper/snapshots.hpp"
#include "server/outbox.hpp"
#include "server/recorder.hpp"
#include "server/service.hpp"

namespace weft::server {

/// What every part of the server works with. Owned by the service; parts hold a reference.
struct Context {
  const ServiceConfig& config;
  storage::MapStore& store;
  Outbox& out;
  Counters& counters;
  Recorder& record;
  Snapshots& snapshots;
};

}  // namespace weft::server
