#pragma once
#include <optional>

#include "agents/navigation/charted.hpp"
#include "agents/navigation/decoded_contents.hpp"

namespace weft::agents {

/// Localises a content that was seen about there by the method, in a chart of its own, of which places of `without`
/// are no part. What looks most alike may stand a place or two further on: then it is looked at from there. Refused:
/// as `locate` does, "nothing_near".
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
