#pragma once
#include <optional>

#include "agents/navigation/charted.hpp"
#include "agents/navigation/decoded_contents.hpp"

namespace weft::agents {

/// Localises a content that the method saw near `at`, in a chart of its own that leaves out the places of `without`.
/// The chart is laid out anew around the place that looks most alike when that lies a place or two further on.
/// Refused: as `locate` does, "nothing_near".
template <ChartsItself M>
OrRefusal<Fix> localised_around(const M& method, const Window& map, const Contents& bytes,
                                DecodedContents<M>& decoded, Estimate at, const typename M::Content& content,
                                const std::optional<ExperienceId>& without = std::nullopt) {
  constexpr int most_looks = 3;
  Charted<M> charted(method);
  for (int look = 0;; ++look) {
    charted.forget();
    charted.prepare(map, bytes, decoded, at, without);
    const auto located = charted.locate(content);
    if (!located.fix)
      return tl::unexpected(located.refusals.empty() ? Refusal{"nothing_near"} : located.refusals.front());
    if (located.fix->place == at.place || look == most_looks) return *located.fix;
    at = {located.fix->place, located.fix->place_from_robot, 0.0};
  }
}

}  // namespace weft::agents
