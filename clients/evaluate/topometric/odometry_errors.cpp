#include "clients/evaluate/topometric/odometry_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::evaluate::topometric {
namespace {

using agents::sim::Blackout;

constexpr double kWrongStepM = 0.020;
constexpr double kWrongStepRad = 2.0 * std::numbers::pi / 180.0;
constexpr double kMovesM = 1e-3;  // in a sample; standing, there is nothing to be blind to
constexpr double kMovesRad = 1e-3;

struct StepError {
  double metres;
  double radians;
  bool is_wrong() const { return metres > kWrongStepM || radians > kWrongStepRad; }
};

StepError error_of(const Pose2& truth, const Pose2& said) {
  const Pose2 off = said.inverse() * truth;
  return {off.translation().norm(), std::abs(off.heading)};
}

bool moves(const Pose2& step) {
  return step.translation().norm() > kMovesM || std::abs(step.heading) > kMovesRad;
}

template <class Counts>
double count_hidden(const agents::sim::Site& site, const Moments& moments, const Counts& counts) {
  return static_cast<double>(std::count_if(moments.begin(), moments.end(), [&](const Moment& moment) {
    return counts(moment) && is_hidden(site, moment);
  }));
}

}  // namespace

std::vector<double> chain_errors_m(const Moments& moments, Pose2 Moment::*chain) {
  std::vector<double> errors;
  if (moments.empty()) return errors;
  const Pose2 first_from_site = moments.front().site_from_robot.inverse();
  const Pose2 first_from_start = (moments.front().*chain).inverse();
  for (const Moment& moment : moments) {
    const Pose2 truth = first_from_site * moment.site_from_robot;
    const Pose2 said = first_from_start * moment.*chain;
    errors.push_back((truth.translation() - said.translation()).norm());
  }
  return errors;
}

FollowedSteps followed_steps(const Moments& moments) {
  FollowedSteps followed;
  const auto begins = std::find_if(moments.begin(), moments.end(), [](const Moment& moment) { return moment.seen; });
  if (begins == moments.end()) return followed;
  Pose2 said_since_seen;
  auto last_seen = begins;
  for (auto now = std::next(begins); now != moments.end(); ++now) {
    const Pose2 truth = std::prev(now)->site_from_robot.inverse() * now->site_from_robot;
    said_since_seen = said_since_seen * now->step;
    const bool counts = moves(truth) || moves(now->step);
    if (counts) followed.samples += 1.0;
    if (!now->seen) {
      if (counts) followed.blind += 1.0;
      continue;
    }
    const StepError alone = error_of(truth, now->step);
    const StepError since = error_of(last_seen->site_from_robot.inverse() * now->site_from_robot, said_since_seen);
    if (counts && alone.is_wrong() && since.is_wrong()) {
      followed.wrong += 1.0;
      followed.largest_wrong_m = std::max(followed.largest_wrong_m, std::min(alone.metres, since.metres));
    }
    last_seen = now;
    said_since_seen = Pose2{};
  }
  return followed;
}

bool is_hidden(const agents::sim::Site& site, const Moment& moment) {
  return std::any_of(site.blackouts.begin(), site.blackouts.end(), [&](const Blackout& blackout) {
    return blackout.kind != Blackout::Kind::frozen &&
           blackout.holds(moment.true_s, moment.site_from_robot.x, moment.site_from_robot.y);
  });
}

double fixes_while_hidden(const agents::sim::Site& site, const Moments& moments) {
  return count_hidden(site, moments, [](const Moment& moment) { return moment.fix.has_value(); });
}

double kept_while_hidden(const agents::sim::Site& site, const Moments& moments) {
  return count_hidden(site, moments, [](const Moment& moment) { return moment.kept.has_value(); });
}

std::vector<double> metres_driven(const Moments& moments) {
  std::vector<double> driven(moments.size(), 0.0);
  for (std::size_t i = 1; i < moments.size(); ++i)
    driven[i] = driven[i - 1] +
                (moments[i].site_from_robot.translation() - moments[i - 1].site_from_robot.translation()).norm();
  return driven;
}

double metres_in(const Moments& moments) {
  return moments.empty() ? 0.0 : metres_driven(moments).back();
}

}  // namespace weft::evaluate::topometric
