#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "agents/methods/bearing/bearing.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/perception/rig.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// A method that an agent can run: what it needs of a body, how it is set, and how it is made of both.
template <class M>
concept Runnable = Method<M> &&
    requires(const typename M::Config& config, const Rig& rig, const config::Table& table) {
  { M::needs } -> std::convertible_to<SensorNeed>;
  /// make: of the sensors that were chosen for it, no others. invalid: a setting or a calibration breaks its bound.
  { M::make(config, rig) } -> std::same_as<Result<M>>;
  /// read_config: of the table [NAME] of a configuration file; what is wrong is collected by the table.
  { M::read_config(table) } -> std::same_as<typename M::Config>;
};

/// A method whose contents can be signed by who has no camera: the server.
template <class M>
concept SignsBytes = requires(ByteView bytes) {
  { M::sign_bytes(bytes) } -> std::same_as<std::optional<Signature>>;
};

template <Runnable... M>
struct MethodList {
  static constexpr std::array<std::string_view, sizeof...(M)> names = {M::name...};

  /// Calls `visit.template operator()<M>()` for each, in their order.
  template <class Visit>
  static void for_each(Visit&& visit) {
    (visit.template operator()<M>(), ...);
  }
};

/// Every method that robots navigate by: who adds one adds it here, and nowhere else.
using AllMethods = MethodList<Floor, Bearing>;

}  // namespace weft::agents
