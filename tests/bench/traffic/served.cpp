#include "tests/bench/traffic/served.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "core/network/codec.hpp"
#include "core/random.hpp"
#include "tests/bench/traffic/fleet.hpp"

namespace weft::bench {
namespace {

constexpr std::size_t kTaughtBy = 65'001;  // beside the robots that drive
constexpr std::size_t kServer = 65'000;
constexpr int kMostTicksAtOnce = 100'000;

Work work_of(const msg::Message& message) {
  if (std::holds_alternative<msg::RobotState>(message)) return Work::state;
  if (std::holds_alternative<msg::RouteProgress>(message)) return Work::progress;
  if (std::holds_alternative<msg::OperatorRequest>(message)) return Work::request;
  return Work::other;
}

/// Stores the lanes as one robot taught them. All places have one content: nobody looks at it.
void store_lanes(const TaughtLanes& lanes, storage::MapStore& store) {
  const Bytes content{1, 2, 3};
  storage::Transaction transaction;
  transaction.changes.emplace_back(storage::PutContent{.hash = hash_bytes(content), .bytes = content});
  for (Batch batch : lanes.batches()) {
    batch.sequence = 1;
    batch.robot = fleet_robot_id(kTaughtBy);
    for (Place& place : batch.places) {
      place.robot = batch.robot;
      place.content = {hash_bytes(content), content.size()};
    }
    const ContentHash hash = hash_bytes(encode(batch));
    transaction.changes.emplace_back(storage::AppendBatch{std::move(batch), hash});
  }
  if (const auto done = store.commit(transaction); !done) throw std::runtime_error(done.error().message);
}

}  // namespace

const char* to_string(Work work) {
  switch (work) {
    case Work::state:
      return "state";
    case Work::progress:
      return "progress";
    case Work::request:
      return "request";
    case Work::other:
      return "other";
    case Work::tick:
      return "tick";
  }
  return "?";
}

Served::Served(const TaughtLanes& lanes) : disk_(std::make_shared<storage::MemoryDisk>()) {
  store_ = storage::make_memory_store(disk_);
  if (const auto opened = store_->open(); !opened) throw std::runtime_error(opened.error().message);
  store_lanes(lanes, *store_);
  store_ = storage::make_memory_store(disk_);
  server::ServiceConfig config;
  config.self = fleet_robot_id(kServer);
  config.incarnation = 1;
  Result<std::unique_ptr<server::Service>> started = server::start(config, *store_, Random(1), now_);
  if (!started) throw std::runtime_error(started.error().message);
  service_ = *std::move(started);
}

void Served::handle(const msg::Message& message) {
  std::vector<msg::Message> said;
  const Took took = timed([&] { said = service_->handle(message, now_); });
  times_[static_cast<std::size_t>(work_of(message))].push_back(took);
  std::move(said.begin(), said.end(), std::back_inserter(said_));
}

void Served::pass_until(SteadyTime end) {
  for (int ticks = 0; ticks < kMostTicksAtOnce; ++ticks) {
    const std::optional<SteadyTime> due = service_->next_tick();
    if (!due || *due > end) break;
    const Duration on = std::max(*due, now_.steady) - now_.steady;
    now_ = {.steady = now_.steady + on, .wall = now_.wall + on};
    std::vector<msg::Message> said;
    const Took took = timed([&] { said = service_->tick(now_); });
    times_[static_cast<std::size_t>(Work::tick)].push_back(took);
    std::move(said.begin(), said.end(), std::back_inserter(said_));
  }
  now_.wall += end - now_.steady;
  now_.steady = end;
}

}  // namespace weft::bench
