#pragma once
#include "agents/methods/method.hpp"

namespace weft::agents {

/// The estimate, by fixes, of the errors that all of a robot's steps along paths have in common: its wheels' scale,
/// and that one is larger than the other (Step::common, columns 0 and 1: ahead alone, heading alone). Estimated
/// together with where the robot is, by the Kalman update of both at once, so that straights stop adding error. A
/// value.
class AlongErrors {
 public:
  /// The step with what has been learnt taken off, and no surer than that is.
  Step improved(const Step& step) const;

  /// A fix: `measured` of the same place as `predicted`, whose part of common errors is `common` (of improved steps;
  /// agents/methods/advance.hpp). `common` is afterwards what the fix leaves of it.
  void learn(const AlongPath& predicted, const AlongPath& measured, CommonErrors& common);

  /// Share by which distances are told too small, and radians a metre by which turns are, in sigmas of a step's own.
  double distance_error() const { return distance_.value; }
  double turn_error() const { return turn_.value; }

 private:
  /// An error in units of the sigma that is stated of it beforehand.
  struct Error {
    double value = 0.0;
    double variance = 1.0;

    /// `part` of the prediction, whose variance is `known`, comes from it; `off`: how much larger it was measured.
    void learn(double off, double known, double measured, double& part);
  };
  Error distance_;
  Error turn_;
};

}  // namespace weft::agents
