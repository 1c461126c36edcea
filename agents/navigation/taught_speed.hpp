#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

#include "agents/methods/method.hpp"
#include "agents/navigation/decoded_contents.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Returns the speed, m/s, at which the stretch at a place was driven when it was taught; where that run stood, as it
/// began or ended, the fastest hereabouts: a route goes on. None: the place, or its content, is not there.
template <Replays M>
std::optional<double> taught_speed(const Window& window, const PlaceId& at, DecodedContents<M>& decoded,
                                   const MapView& map) {
  constexpr double slowest_m_s = 0.2;
  constexpr std::uint32_t either_way = 4;  // places
  const auto driven_m_s = [&](std::uint32_t index) -> std::optional<double> {
    const Place* const place = window.place({at.experience, index});
    if (place == nullptr) return std::nullopt;
    const auto content = decoded.find(*place, map.contents);
    return content ? std::optional(M::driven(**content).linear_m_s) : std::nullopt;
  };
  const std::optional<double> here_m_s = driven_m_s(at.index);
  if (!here_m_s || *here_m_s >= slowest_m_s) return here_m_s;
  double fastest_m_s = slowest_m_s;
  for (std::uint32_t index = at.index - std::min(at.index, either_way); index <= at.index + either_way; ++index)
    fastest_m_s = std::max(fastest_m_s, driven_m_s(index).value_or(slowest_m_s));
  return fastest_m_s;
}

}  // namespace weft::agents
