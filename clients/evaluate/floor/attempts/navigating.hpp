#pragma once
#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "clients/evaluate/floor/attempts/known_places.hpp"
#include "clients/evaluate/floor/attempts/passages.hpp"
#include "clients/evaluate/floor/attempts/tally.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "core/random.hpp"

namespace weft::evaluate::floor {

/// Tries what navigation takes for a fix or a stitch while a passage is driven: the navigator's own parts with every
/// setting at its default, on the whole network that was taught. A robot that knows nothing seeks; one that knows
/// where it is tracks, one that only believes so too; and its first and last view are stitched as places just kept.
class Navigating {
 public:
  Navigating(const agents::Floor& method, const Taught& taught, const KnownPlaces& places);

  void navigate(const Passage& passage, bool is_other_floor, Random& random, Tally& tally);

 private:
  void seek(const Passage& passage, bool is_other_floor, Tally& tally);
  void track(const Passage& passage, bool knows, Random& random, Tally& tally);
  void stitch(const Passage& passage, bool knows, Random& random, Tally& tally);

  const agents::Floor& method_;
  const Taught& taught_;
  const KnownPlaces& places_;
  agents::NavigationConfig config_;
  agents::DecodedContents<agents::Floor> decoded_;
};

}  // namespace weft::evaluate::floor
