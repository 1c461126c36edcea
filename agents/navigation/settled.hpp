#pragma once
#include "agents/navigation/agreement.hpp"
#include "agents/navigation/belief.hpp"
#include "agents/navigation/localised_around.hpp"

namespace weft::agents {

/// Returns where a robot stands that has found itself about `found`: two contents that look alike anywhere say little
/// of how far along a path it is, the places around say more, now and not only on the way. A method that compares
/// rivals has to find the view in the nearest place itself, too. Refused: as `locate` and `relate` do; "not_joined",
/// "settles_elsewhere" (metres from what was found, and their bound).
template <ChartsItself M>
OrRefusal<Fix> settled(const M& method, const NavigationConfig& config, const Window& map, const Contents& bytes,
                       DecodedContents<M>& decoded, const Estimate& found, const typename M::Content& seen) {
  constexpr double most_sigmas = 3.0;
  const OrRefusal<Fix> fix = localised_around(method, map, bytes, decoded, found, seen);
  if (!fix) return fix;
  const auto found_from_fix = between(config.belief, map, found.place, fix->place, config.locate.most_hops);
  if (!found_from_fix) return tl::unexpected(Refusal{"not_joined"});
  const Relation found_from_robot = compose(*found_from_fix, fix->place_from_robot);
  const double apart_m = distance_m(compose(inverse(found.place_from_robot), found_from_robot));
  const double bound_m = most_sigmas * spread_of(found.place_from_robot).metres;
  if (apart_m > bound_m) return tl::unexpected(Refusal{"settles_elsewhere", apart_m, bound_m});
  if constexpr (ComparesRivals<M>) {
    const auto there = decoded.find(*map.place(fix->place), bytes);
    if (!there) return tl::unexpected(there.error());
    if (const auto shown = method.relate(**there, seen, std::nullopt); !shown) return tl::unexpected(shown.error());
  }
  return fix;
}

}  // namespace weft::agents
