#pragma once
#include "agents/methods/method.hpp"

namespace weft::agents {

/// a_from_robot after one more step. Errors that all steps have in common add up with their sign, so they grow with
/// the way; all others by its root. `common` is what the former have done to a_from_robot so far (part of its
/// covariance): zero at first, and carried along from step to step.
Relation advanced(const Relation& a_from_robot, const Step& step, CommonErrors& common);

/// `common` of a_from_robot after a measurement has made `before` of its covariance to `after`: as much of it is left
/// as of what was believed (I - K, K being the gain of a Kalman update).
CommonErrors corrected(const CommonErrors& common, const Relation& before, const Relation& after);

/// Two steps, one after the other, as one.
Step joined(const Step& first, const Step& second);

/// Two motions, one after the other, as one: the command in force on the mean, wheels where both have them.
Motion joined(const Motion& first, const Motion& second);

}  // namespace weft::agents
