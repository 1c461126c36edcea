#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "agents/methods/bearing/bearing.hpp"
#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/rig.hpp"
#include "core/config/config.hpp"

namespace weft::agents {

/// Describes a method that an agent can run: what it needs of a body, how it is set, and how it is made of both.
template <class M>
concept Runnable = Method<M> &&
    requires(const typename M::Config& config, const Rig& rig, const config::Table& table) {
  { M::needs } -> std::convertible_to<SensorNeed>;
  /// Makes a method of the sensors chosen for it and no others. invalid: a setting or a calibration breaks its bound.
  { M::make(config, rig) } -> std::same_as<Result<M>>;
  /// Reads the settings from the table [NAME] of a configuration file; the table collects what is wrong.
  { M::read_config(table) } -> std::same_as<typename M::Config>;
};

/// Describes a method whose contents can be signed by a process that has no camera: the server.
template <class M>
concept SignsBytes = requires(ByteView bytes) {
  { M::sign_bytes(bytes) } -> std::same_as<std::optional<Signature>>;
};

/// Describes a method whose contents hold a picture of the plane that they show, the patch, which people can look at.
template <class M>
concept PicturesPlane = requires(ByteView bytes) {
  /// Returns the patch that a content holds. corrupt, newer: the bytes are no content that this program reads.
  { M::patch_of_bytes(bytes) } -> std::same_as<Result<PlanePatch>>;
};

/// Describes a method whose contents are clouds (docs/formats/cloud.md) in the level frame of their place, z above
/// the floor.
template <class M>
concept StoresClouds = M::contents_are_clouds;

template <Runnable... M>
struct MethodList {
  static constexpr std::array<std::string_view, sizeof...(M)> names = {M::name...};

  /// Calls `visit.template operator()<M>()` for each, in their order.
  template <class Visit>
  static void for_each(Visit&& visit) {
    (visit.template operator()<M>(), ...);
  }
};

/// Lists every method that robots navigate by: whoever adds a method adds it here and nowhere else.
using AllMethods = MethodList<Floor, Bearing, Ceiling, Topometric>;

}  // namespace weft::agents
