#pragma once
#include <tuple>

#include "agents/methods/all.hpp"
#include "agents/navigation/method_settings.hpp"

namespace weft::agents {

/// Holds the settings of one method: its own table, [NAME], and how navigation goes with it, [navigation] and
/// [NAME.navigation].
template <class M>
struct Configured {
  typename M::Config config;
  NavigationConfig navigation;
};

template <class List>
struct ConfiguredOf;
template <class... M>
struct ConfiguredOf<MethodList<M...>> {
  using Type = std::tuple<Configured<M>...>;
};
/// Holds the settings of each method.
using MethodSettings = ConfiguredOf<AllMethods>::Type;

/// Reads the settings of method M of a configuration file: a setting of [NAME.navigation] wins over [navigation],
/// that one over the method's own default, that one over `base`.
template <class M>
Configured<M> read_configured(const config::Table& file, const NavigationConfig& base) {
  const config::Table own = file.table(M::name);
  const NavigationConfig common = read_navigation_config(file.table("navigation"), navigation_defaults<M>(base));
  Configured<M> read;
  read.navigation = read_navigation_config(own.table("navigation"), common);
  read.config = M::read_config(own);
  return read;
}

}  // namespace weft::agents
