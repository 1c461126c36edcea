#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "tests/support/marks.hpp"

namespace weft::agents {

/// Refines `marks` in a way that shows: moves each relation within a run by a tenth of a millimetre and each first
/// sighting of a place, and gives those relations a covariance by which they are known again.
class RefiningMarks : public MarksMethod {
 public:
  using MarksMethod::MarksMethod;
  static constexpr std::size_t places_a_piece = 10;
  static constexpr double shift_m = 1e-4;

  struct Refinement {
    std::vector<ExperiencePlace<Content>> places;
    std::size_t next = 0;  ///< index into places
    Amendments<Content> changes;
  };

  Refinement begin_refine(const std::vector<ExperiencePlace<Content>>& places) const { return {places, 0, {}}; }
  bool refine(Refinement& refinement) const {
    const std::size_t end = std::min(refinement.next + places_a_piece, refinement.places.size());
    for (; refinement.next < end; ++refinement.next) amend(refinement.places[refinement.next], refinement.changes);
    return refinement.next < refinement.places.size();
  }
  std::size_t pieces(const Refinement& refinement) const {
    return (refinement.places.size() + places_a_piece - 1) / places_a_piece;
  }
  Amendments<Content> refined(Refinement refinement) const { return std::move(refinement.changes); }

  static bool is_refined(const Relation& relation) {
    const auto* const metric = std::get_if<Metric2>(&relation);
    return metric != nullptr && metric->covariance(0, 1) == known_again;
  }

 private:
  static constexpr double known_again = 1e-12;  // m^2, of x and y

  static void amend(const ExperiencePlace<Content>& place, Amendments<Content>& changes) {
    for (const Edge& edge : place.edges) {
      const auto* const taught = std::get_if<Metric2>(&edge.a_from_b);
      if (edge.id.a.experience != place.id.experience || taught == nullptr) continue;
      Metric2 better = *taught;
      better.a_from_b.x += shift_m;
      better.covariance(0, 1) = better.covariance(1, 0) = known_again;
      changes.edges.push_back({edge.id, better});
    }
    Content content = *place.content;
    content.sightings.front().robot_from_mark.x -= shift_m;
    changes.places.push_back({place.id, std::move(content)});
  }
};
static_assert(Refines<RefiningMarks> && !Refines<MarksMethod>);

}  // namespace weft::agents
