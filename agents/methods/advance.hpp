#pragma once
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Returns a_from_robot after one more step. Errors that all steps have in common add up with their sign, so they
/// grow with the way; all others add up as variances, so they grow with its root. `common` is what the former have
/// done to a_from_robot so far (part of its covariance): zero at first, and carried along from step to step.
Relation advanced(const Relation& a_from_robot, const Step& step, CommonErrors& common);

/// Returns `common` of a_from_robot after a measurement has turned the relation `before` into `after`: as much of it
/// is left as of the covariance (a factor of I - K, K being the gain of a Kalman update).
CommonErrors corrected(const CommonErrors& common, const Relation& before, const Relation& after);

/// Returns one step in place of two consecutive ones; it is `seen` only if both are.
Step joined(const Step& first, const Step& second);

/// Returns one motion in place of two consecutive ones: the mean command, and the wheels' where both have them.
Motion joined(const Motion& first, const Motion& second);

}  // namespace weft::agents
