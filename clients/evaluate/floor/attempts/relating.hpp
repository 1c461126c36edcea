#pragma once
#include "agents/methods/floor/floor.hpp"
#include "clients/evaluate/floor/attempts/known_places.hpp"
#include "clients/evaluate/floor/attempts/passages.hpp"
#include "clients/evaluate/floor/attempts/tally.hpp"
#include "core/random.hpp"

namespace weft::evaluate::floor {

/// Relates each view of a passage to places, without navigation: to two that share floor with it, and to others that
/// share none or are guessed elsewhere. `is_other_floor`: nothing that it sees is known.
void relate_passage(const agents::Floor& method, const KnownPlaces& places, const Passage& passage,
                    bool is_other_floor, Random& random, Tally& tally);

}  // namespace weft::evaluate::floor
