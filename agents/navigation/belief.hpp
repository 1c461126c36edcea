#pragma once
#include <optional>

#include "agents/methods/along_errors.hpp"
#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Returns `relation` with extra independent uncertainty (one sigma) at its b end.
Relation with_noise(const Relation& relation, double sigma_m, double sigma_rad);

/// Returns how far two relations between the same two frames lie apart, in sigmas (Mahalanobis over x, y, heading;
/// the configured floor is part of the covariance).
double disagreement(const BeliefConfig& config, const Relation& predicted, const Relation& measured);

/// Returns the covariance-weighted mean of a prediction and a measurement of the same relation: a Kalman update on
/// SE(2) or SE(3) in the frame of the predicted pose, per component along a path. Returns the measured one when the
/// two are of different kinds.
Relation fuse(const Relation& predicted, const Relation& measured);

/// Returns a_from_b through at most `hops` edges of the window, with the map's own noise for each; none if they are
/// not joined.
std::optional<Relation> between(const BeliefConfig& config, const Window& window, const PlaceId& a, const PlaceId& b,
                                std::uint32_t hops);

/// Keeps the pose that the robot believes: one hypothesis, moved by odometry, corrected by fixes that agree with it,
/// and overruled or found anew only by fixes that agree with one another. A value, pure.
class Belief {
 public:
  /// `posterior`: fixes are what odometry and views say together; those that agree are taken as they are.
  explicit Belief(const BeliefConfig& config, bool posterior = false) : config_(config) {
    config_.fuse = config_.fuse && !posterior;
  }

  const std::optional<Estimate>& estimate() const { return estimate_; }
  void advance(const Step& step);
  /// Trusts this fix from now on, as if it had just been seen.
  void set(const Fix& fix);
  void forget();
  /// Expresses the same belief relative to another place.
  void stand(const Estimate& estimate) { estimate_ = estimate; }

  /// Takes a fix of a robot that knows about where it is; `predicted` is of the same place. Returns the fix as
  /// believed (fused, or a posterior as it is). Refused: "disagrees_with_prediction", measured and bound in sigmas.
  OrRefusal<Fix> correct(const Fix& fix, const Relation& predicted, const Window& window);
  /// Takes a fix of a robot that knows nothing: it is believed once `needed` in a row agree with one another under
  /// the odometry between them. Refused until then: "unconfirmed".
  OrRefusal<Fix> propose(const Fix& fix, const Window& window, std::uint32_t needed);
  /// Forgets what was proposed and is not believed.
  void withdraw();
  /// Returns the last fix proposed and not believed, moved along with the robot.
  const std::optional<Fix>& proposed() const { return proposed_; }

 private:
  /// Returns the part of the common errors that a fix leaves in what was predicted; along a path it learns from the
  /// fix.
  CommonErrors left_of_common(const Relation& predicted, const Fix& fix, const Relation& believed);

  BeliefConfig config_;
  std::optional<Estimate> estimate_;
  std::optional<Fix> proposed_;
  CommonErrors common_ = CommonErrors::Zero();  // in estimate_
  CommonErrors common_of_proposed_ = CommonErrors::Zero();
  std::uint32_t agreed_ = 0;  // fixes in a row behind proposed_
  AlongErrors errors_;        // of the robot's own steps: they stay when it does not know where it is
};

}  // namespace weft::agents
