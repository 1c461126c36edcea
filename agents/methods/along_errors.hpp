#pragma once
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Estimates, from fixes, the errors that all of a robot's steps along paths have in common: the scale of its wheels,
/// and that one is larger than the other (Step::common, columns 0 and 1: ahead alone, heading alone). They are
/// estimated together with where the robot is, by the Kalman update of both at once, so that straights stop adding
/// error. A value.
class AlongErrors {
 public:
  /// Returns the step with the learnt errors taken off, and their part of its covariance reduced to what is not
  /// known.
  Step improved(const Step& step) const;

  /// Learns from a fix: `measured` is of the same place as `predicted`, whose part of common errors is `common` (of
  /// improved steps; agents/methods/advance.hpp). Changes `common` to what the fix leaves of it.
  void learn(const AlongPath& predicted, const AlongPath& measured, CommonErrors& common);

  /// Return the share by which distances are told too small, and radians a metre by which turns are, each in units of
  /// the sigma that steps state of it.
  double distance_error() const { return distance_.value; }
  double turn_error() const { return turn_.value; }

 private:
  /// Describes an error in units of the sigma that is stated of it beforehand.
  struct Error {
    double value = 0.0;
    double variance = 1.0;

    /// Learns that a quantity was measured larger than predicted by `off`. `known`, `measured`: variances of the two;
    /// `part`: 1 sigma of this error in the prediction, changed to what is left of it.
    void learn(double off, double known, double measured, double& part);
  };
  Error distance_;
  Error turn_;
};

}  // namespace weft::agents
