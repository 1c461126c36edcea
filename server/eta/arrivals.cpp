#include "server/eta/arrivals.hpp"

#include <chrono>
#include <utility>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr std::size_t kRatiosKept = 100;
/// Bounds what tells something of a band: the end of a short way is mostly braking.
constexpr double kShort_s = 5.0;
constexpr Duration kBetweenRounds = 30s;
/// Bounds what one commit carries: about a millisecond of it.
constexpr std::size_t kPiecesOfCommit = 100;

}  // namespace

void Band::add(double real_s, double foretold_s) {
  if (foretold_s < kShort_s) return;
  if (ratios_.size() == kRatiosKept) ratios_.pop_front();
  ratios_.push_back(real_s / foretold_s);
}

double Band::of_foretold(double share, double if_few) const {
  return ratios_.size() < kFewest ? if_few : quantile({ratios_.begin(), ratios_.end()}, share);
}

void Arrivals::on_report(const RobotId& robot, const Route& route, const msg::RouteProgress& report, SteadyTime now) {
  Followed& followed = robots_[robot];
  if (followed.route != route.id) followed = {.route = route.id, .passing = {}, .from = report.at, .half_way = {}};
  followed.passing.on_report(route, report.at, report.phase, now, speeds_);
  compare(followed, route, report, now);
}

void Arrivals::compare(Followed& robot, const Route& route, const msg::RouteProgress& report, SteadyTime now) {
  const bool is_on_its_way = report.phase == msg::RoutePhase::driving || report.phase == msg::RoutePhase::waiting;
  if (report.phase == msg::RoutePhase::stopped || report.phase == msg::RoutePhase::failed) robot.is_disturbed = true;
  if (!robot.half_way && is_on_its_way && 2 * report.at >= robot.from + route.places.size()) {
    robot.half_way = {now, speeds_.left(route, report.at).total_s()};
  }
  if (report.phase != msg::RoutePhase::arrived || !robot.half_way || robot.is_disturbed) return;
  band_.add(seconds(now - robot.half_way->at), robot.half_way->left_s);
  robot.half_way.reset();
}

msg::Arrival Arrivals::foretell(const RobotId& robot, const Route& route) const {
  const auto found = robots_.find(robot);
  const bool is_known = found != robots_.end() && found->second.route == route.id;
  const double left_s = speeds_.left(route, is_known ? found->second.passing.at(route) : 0).total_s();
  return {
      .goal = route.goal, .in_s = left_s, .soonest_s = band_.soonest() * left_s, .latest_s = band_.latest() * left_s};
}

std::vector<storage::PutPasses> Arrivals::due(SteadyTime now) {
  if (now < next_round_) return {};
  std::vector<storage::PutPasses> passes = speeds_.take_unsaved(kPiecesOfCommit);
  if (!speeds_.has_unsaved()) next_round_ = now + kBetweenRounds;
  return passes;
}

}  // namespace weft::server
