#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "core/network/codec.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {

/// Describes a straight run of one method: a place for each content, so far apart, one of them labelled.
struct HandedInRun {
  ExperienceId experience;
  std::string method;
  std::vector<Bytes> contents;
  double apart_m = 0.5;
  Drivable drivable = Drivable::a_to_b;
  std::string label;
  std::uint32_t labelled = 0;  ///< index
};

/// Puts the run into the store, as intake does, and starts the server anew on that.
inline void hand_in(Fleet& fleet, const HandedInRun& run) {
  Batch batch;
  batch.experience = run.experience;
  batch.sequence = 1;
  batch.robot.bytes.fill(17);
  batch.method = run.method;
  batch.seal = true;
  batch.seal_reason = "taught to its end";
  storage::Transaction transaction;
  for (const Bytes& bytes : run.contents) {
    Place place;
    place.id = {run.experience, static_cast<std::uint32_t>(batch.places.size())};
    place.method = run.method;
    place.content = {hash_bytes(bytes), bytes.size()};
    place.robot = batch.robot;
    transaction.changes.emplace_back(storage::PutContent{place.content.hash, msg::ContentKind::content, bytes});
    if (!batch.places.empty()) {
      Edge edge;
      edge.id = {batch.places.back().id, place.id};
      edge.a_from_b = Metric2{{run.apart_m, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4};
      edge.method = run.method;
      edge.drivable = run.drivable;
      batch.edges.push_back(edge);
    }
    batch.places.push_back(place);
  }
  transaction.changes.emplace_back(storage::AppendBatch{batch, hash(batch)});
  transaction.changes.emplace_back(storage::PutLabel{run.label, {run.experience, run.labelled}});
  const std::unique_ptr<storage::MapStore> store = storage::make_memory_store(fleet.disk);
  ASSERT_TRUE(store->open().has_value());
  const auto committed = store->commit(transaction);
  ASSERT_TRUE(committed.has_value()) << committed.error().message;
  fleet.restart_server();
  fleet.run(std::chrono::milliseconds(100));
}

}  // namespace weft::cli::test
