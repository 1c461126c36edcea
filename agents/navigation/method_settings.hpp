#pragma once
#include <concepts>
#include <string>
#include <string_view>

#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Describes a method that wants other settings of navigation than most: TOML, as a table [navigation] has them.
template <class M>
concept HasNavigationDefaults = requires {
  { M::navigation_defaults } -> std::convertible_to<std::string_view>;
};

/// Returns the settings of navigation that method M drives with when nobody says otherwise, made of `base`.
template <class M>
NavigationConfig navigation_defaults(const NavigationConfig& base = {}) {
  if constexpr (HasNavigationDefaults<M>)
    return read_navigation_config(config::parse(M::navigation_defaults, std::string(M::name)), base);
  return base;
}

}  // namespace weft::agents
