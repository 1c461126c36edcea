#pragma once
#include "server/base/config.hpp"
#include "server/base/now.hpp"
#include "server/base/outbox.hpp"
#include "server/base/recorder.hpp"
#include "server/base/snapshots.hpp"

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
