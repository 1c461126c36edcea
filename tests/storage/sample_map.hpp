#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/network/change.hpp"
#include "core/random.hpp"
#include "storage/map_store.hpp"

/// Makes up maps for the tests of stores and spools: same seed, same bytes.
namespace weft::storage::sample {

RobotId robot(std::uint64_t number);
GoalId goal_id(std::uint64_t number);

/// Returns bytes that compress to about half.
Bytes content(Random& random, std::size_t size);

struct Delivery {
  Batch batch;
  std::vector<Bytes> contents;
};
/// Puts contents and batch together, as intake commits them.
Transaction transaction(const Delivery& delivery);

/// Makes one robot's run: each call gives the next batch.
class Run {
 public:
  Run(std::uint64_t experience, std::uint64_t seed);
  Delivery next(std::uint32_t places, std::size_t content_bytes = 200);
  ExperienceId experience() const { return experience_; }

 private:
  Random random_;
  ExperienceId experience_;
  std::uint64_t sequence_ = 0;
  std::uint32_t places_ = 0;
};

Edge stitch(const PlaceId& older, const PlaceId& newer);
/// Returns the place as a robot knows it better, with the content `better`.
Place known_anew(const Place& place, const Bytes& better, const RobotId& by);
Goal goal(std::uint64_t number, const PlaceId& to);
Route route(std::uint64_t number, const PlaceId& from, const PlaceId& to);

/// Return everything that a store gave back, except its epoch, one line an item: equal lists are equal stores.
std::vector<std::string> describe(const Stored& stored);
std::vector<std::string> describe(const Snapshot& snapshot);

}  // namespace weft::storage::sample
