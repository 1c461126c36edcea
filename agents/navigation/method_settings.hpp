#pragma once
#include <string_view>

#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Returns the settings of navigation that method M drives with when nobody says otherwise, made of `base`.
template <class M>
NavigationConfig navigation_defaults(const NavigationConfig& base = {}) {
  if constexpr (requires { std::string_view(M::navigation_defaults); })
    return read_navigation_config(config::parse(M::navigation_defaults, M::name.data()), base);
  return base;
}

}  // namespace weft::agents
