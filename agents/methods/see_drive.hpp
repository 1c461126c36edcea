#pragma once
#include <concepts>
#include <optional>
#include <utility>

#include "agents/methods/method.hpp"
#include "agents/perception/mount_drive.hpp"

namespace weft::agents {

/// Describes a method whose odometry hands on the pairs of views, of one plane, that a mount is found from.
template <class M>
concept ShowsMount = Method<M> && requires(typename M::Odometry& odometry) {
  { odometry.ended } -> std::same_as<std::optional<PlaneViews>&>;
};

/// Goes once through a drive with a method's own odometry. Errors of `play`.
template <ShowsMount M>
Result<DriveSeen> see_drive(const M& method, const PlayDrive& play) {
  typename M::Odometry odometry;
  DriveSeen out;
  const Result<void> played = play([&](const View* view, const Motion& motion) {
    const Step step = method.observe(odometry, view, motion);
    const Pose2 moved = planar(step.previous_from_current);
    out.first_from_last = out.first_from_last * moved;
    out.path_m += moved.translation().norm();
    out.blind += step.seen || out.samples == 0 ? 0U : 1U;
    ++out.samples;
    if (!odometry.ended.has_value()) return;
    out.views.push_back(std::move(*odometry.ended));
    const PlaneViews& views = out.views.back();
    if (!views.wheels.has_value()) return;
    out.wheels_m += views.wheels->translation().norm();
    out.seen_beside_m += views.a_from_b.translation().norm();
  });
  if (!played) return fail(played.error());
  return out;
}

}  // namespace weft::agents
