#include "clients/evaluate/topometric/ride.hpp"

#include <algorithm>
#include <ctime>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "agents/navigation/method_settings.hpp"
#include "agents/navigation/navigator_of.hpp"
#include "clients/evaluate/exposed.hpp"
#include "clients/evaluate/truth.hpp"
#include "core/network/search.hpp"

namespace weft::evaluate::topometric {

using namespace agents;

namespace {

double process_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

BelievedAt at(const PlaceId& place, const Relation& place_from_robot) {
  return {place, planar(place_from_robot), planar_covariance(place_from_robot)};
}

/// Returns by how much a belief lies beside what it was before, both expressed at the place before, as the map has
/// it. Not a number: the map does not join the two.
double jump_between(const Estimate& before, const Pose2& step, const Estimate& after, const Window& map) {
  const Pose2 expected = planar(before.place_from_robot) * step;
  Pose2 before_from_after;
  if (before.place != after.place) {
    const auto reached = breadth_first(map, before.place, Topometric::chart_size.hops, Topometric::chart_size.places);
    const auto found =
        std::find_if(reached.begin(), reached.end(), [&](const Reached& one) { return one.id == after.place; });
    if (found == reached.end()) return std::numeric_limits<double>::quiet_NaN();
    before_from_after = planar(found->centre_from_place);
  }
  return (expected.inverse() * before_from_after * planar(after.place_from_robot)).translation().norm();
}

Result<void> remove_file(const std::filesystem::path& file) {
  std::error_code problem;
  std::filesystem::remove(file, problem);
  if (problem) return fail(ErrorCode::unavailable, file.string() + ": " + problem.message());
  return {};
}

}  // namespace

Result<std::unique_ptr<Ride>> Ride::make(const Rider& rider) {
  if (const Result<void> removed = remove_file(rider.scratch); !removed) return fail(removed.error());
  sim::SimBodyConfig config;
  config.site = rider.site;
  config.robot = rider.robot;
  config.seed = rider.seed;
  config.day = rider.day;
  config.truth_path = rider.scratch.string();
  auto body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  const Rig rig = (*body)->rig();
  const Result<Topometric> method = Topometric::make(rider.settings, rig);
  if (!method) return fail(method.error());
  Result<RawOdometry> raw = RawOdometry::make(rider.settings.open.seeing, rig.sensors.front());
  if (!raw) return fail(raw.error());
  return std::unique_ptr<Ride>(new Ride(rider, std::move(*body), *method, std::move(*raw)));
}

Ride::Ride(const Rider& rider, std::unique_ptr<sim::SimulatedBody> body, const Topometric& method, RawOdometry raw)
    : truth_(rider.scratch),
      body_(std::move(body)),
      method_(method),
      noted_(std::make_shared<Noted>()),
      navigator_(make_navigator(NotedTopometric(method, noted_), navigation_defaults<NotedTopometric>())),
      raw_(std::move(raw)) {}

Ride::~Ride() {
  std::error_code ignored;  // a left-over file is removed at the next start
  std::filesystem::remove(truth_, ignored);
}

Result<Ride::Stepped> Ride::step(const TaughtMap& map) {
  const Result<Sample> sample = body_->step(command_);
  if (!sample) return fail(sample.error());
  const std::optional<Estimate> before = navigator_->estimate();
  const double began_ms = process_ms();
  Stepped stepped{navigator_->step(*sample, map.view()), sample->hand_done};
  const double processor_ms = process_ms() - began_ms;
  command_ = stepped.navigated.command;
  if (!stepped.navigated.refusals.empty()) last_refused_ = stepped.navigated.refusals;
  expose(*body_, stepped.navigated);
  signs_.answer(*navigator_, map);
  raw_.take(*sample);
  note(*sample, stepped.navigated, map, processor_ms, before);
  return stepped;
}

void Ride::note(const Sample& sample, const Navigated& now, const TaughtMap& map, double processor_ms,
                const std::optional<Estimate>& before) {
  Moment moment;
  moment.frame = sample.frame;
  moment.sensor_s = seconds(sample.time.time_since_epoch());
  moment.has_view = !sample.views.empty();
  moment.seen = noted_->step.seen;
  moment.blind_reason = noted_->step.blind_reason;
  moment.step = planar(noted_->step.previous_from_current);
  start_from_robot_ = start_from_robot_ * moment.step;
  moment.start_from_robot = start_from_robot_;
  moment.raw_start_from_robot = raw_.start_from_robot();
  const std::optional<Estimate> after = navigator_->estimate();
  if (after) moment.believed = at(after->place, after->place_from_robot);
  if (now.fix) moment.fix = at(now.fix->place, now.fix->place_from_robot);
  if (!now.kept.empty()) moment.kept = now.kept.back().place.id;
  moment.command = now.command;
  moment.following = now.following;
  moment.reason = now.reason;
  moment.lost = now.lost;
  moment.has_switched = noted_->has_switched;
  if (moment.has_switched && before && after)
    moment.jump_m = jump_between(*before, moment.step, *after, map.view().window);
  if (moment.has_view) moment.processor_ms = processor_ms;
  moments_.push_back(moment);
}

std::string Ride::last_refused() const {
  std::ostringstream text;
  std::set<std::string_view> told;
  for (const Refusal& refusal : last_refused_) {
    if (!told.insert(refusal.reason).second) continue;
    text << (told.size() > 1 ? ", " : "") << refusal.reason << ' ' << refusal.measured << " of " << refusal.bound;
  }
  return text.str();
}

void Ride::note_kept(const std::vector<Kept>& kept) {
  if (!kept.empty()) moments_.back().kept = kept.back().place.id;
}

Result<Moments> Ride::finish() {
  const auto truth = read_truth(truth_);
  if (!truth) return fail(truth.error());
  for (Moment& moment : moments_) {
    const auto found = truth->find(moment.frame);
    if (found == truth->end())
      return fail(ErrorCode::internal, truth_.string() + ": has no frame " + std::to_string(moment.frame) +
                                           "; is somebody else using it?");
    moment.true_s = found->second.true_s;
    moment.site_from_robot = found->second.site_from_robot;
    moment.touch = found->second.touch;
  }
  return std::move(moments_);
}

}  // namespace weft::evaluate::topometric
