#pragma once
#include <cmath>
#include <optional>

#include "tests/support/marks.hpp"

namespace weft::agents {

/// Extends `marks` with places that count the passes by them, and share that after so many.
class LearningMarks : public MarksMethod {
 public:
  static constexpr std::uint32_t learned_format = 2;

  explicit LearningMarks(std::size_t passes = 1) : passes_(passes) {}

  /// Adds one sighting for the pass, with the number of a mark that the content does not have.
  std::optional<Content> learn(const Content& known, const Content& seen, const Relation& known_from_seen) const {
    constexpr double near_m = 0.12;
    if (std::abs(planar(known_from_seen).x) > near_m || seen.sightings.empty()) return std::nullopt;
    Content learned = known;
    learned.sightings.emplace_back();
    learned.sightings.back().mark = known.sightings.empty() ? 1 : known.sightings.back().mark + 1;
    return learned;
  }
  bool is_worth_sharing(const Content& shared, const Content& learned) const {
    return learned.sightings.size() >= shared.sightings.size() + passes_;
  }

 private:
  std::size_t passes_;
};

}  // namespace weft::agents
