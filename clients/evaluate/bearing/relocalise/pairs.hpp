#pragma once
#include <cstddef>

#include "clients/evaluate/bearing/relocalise/led.hpp"

namespace weft::evaluate::bearing {

/// Counts pairs of places of different aisles, or far apart in one, that were compared with each other.
struct Pairs {
  std::size_t tried = 0;
  std::size_t voted = 0;    ///< of which the heading vote alone tells a heading
  std::size_t related = 0;  ///< of which the method says without a guess that they show the same

  void add(const Pairs& other) {
    tried += other.tried;
    voted += other.voted;
    related += other.related;
  }
};

/// Compares so many pairs of what was taught, drawn by the seed. corrupt: a content cannot be read.
Result<Pairs> hold_pairs(const agents::CameraModel& camera, const TaughtAisles& taught, std::size_t count,
                         std::uint64_t seed);

}  // namespace weft::evaluate::bearing
