#include "clients/evaluate/odometry/study.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "agents/bodies/sim/changes.hpp"
#include "agents/methods/floor/floor.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/calibrated.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/odometry/keyframe_odometry.hpp"
#include "clients/evaluate/odometry/regions.hpp"
#include "clients/evaluate/odometry/rehearsal.hpp"
#include "clients/evaluate/odometry/row_file.hpp"

namespace weft::evaluate::odometry {
namespace {

constexpr double kCandidatesOverM = 8.0;

using CpuTime = std::function<double()>;

/// Watches with the product, every setting at its default but for what is known of its camera.
Result<Observer> product(const std::string& name, std::size_t every, const agents::CameraModel& camera,
                         const CpuTime& cpu_s) {
  Result<agents::Floor> made = agents::Floor::make({}, camera);
  if (!made) return fail(made.error());
  const auto method = std::make_shared<const agents::Floor>(std::move(*made));
  const auto state = std::make_shared<agents::Floor::Odometry>();
  return Observer(
      name, every,
      [method, state](const agents::View* view, const agents::Motion& motion) {
        return method->observe(*state, view, motion);
      },
      cpu_s);
}

Observer candidate(const std::string& name, std::size_t every, const agents::CameraModel& camera,
                   const CpuTime& cpu_s) {
  const auto state = std::make_shared<KeyframeOdometry>(make_front_end(name, camera, vibration_alone()));
  return Observer(
      name, every,
      [state](const agents::View* view, const agents::Motion& motion) { return state->observe(view, motion); },
      cpu_s);
}

/// Describes a drive, and at which share of its images it is watched.
struct Rehearsed {
  std::string name;
  floor::Drive drive;
  std::vector<agents::SitePoint> line;
  std::vector<std::size_t> every;
};

std::vector<Rehearsed> drives_of(const floor::Scenario& scenario, const OdometryOptions& options) {
  if (options.regions) return {{kMappingDrive, scenario.first(), scenario.line(), {1}}};
  if (!options.candidates) {
    return {{kMappingDrive, scenario.first(), scenario.line(), {1, 2, 4}},
            {"1.5 m/s", scenario.fast(), scenario.fast_line(), {1}}};
  }
  const auto part = scenario.line_beginning(kCandidatesOverM);
  std::vector<Rehearsed> drives = {{kMappingDrive, scenario.first(), part, {1, 4}},
                                   {"1.5 m/s", scenario.fast(), scenario.fast_line(), {1}}};
  floor::Drive dark = scenario.first();
  const auto site = agents::sim::under_light(dark.body.site, "halved");
  if (site) dark.body.site = *site;
  drives.push_back({"half the light", std::move(dark), part, {1}});
  return drives;
}

std::string named(const std::string& drive, std::size_t every) {
  return every == 1 ? drive : drive + ", 1 image of " + std::to_string(every);
}

/// Returns who watches: the product with both cameras, or all candidates beside it.
Result<std::vector<Observer>> watchers(const Rehearsed& rehearsed, const agents::CameraModel& calibrated,
                                       const OdometryOptions& options, const CpuTime& cpu_s) {
  const Result<std::unique_ptr<agents::Body>> body = agents::sim::make_sim_body(rehearsed.drive.body);
  if (!body) return fail(body.error());
  std::vector<Observer> observers;
  for (const std::size_t every : rehearsed.every) {
    Result<Observer> ours = product(kCalibrated, every, calibrated, cpu_s);
    if (!ours) return fail(ours.error());
    observers.push_back(std::move(*ours));
    if (options.candidates) {
      for (const std::string& name : front_ends()) observers.push_back(candidate(name, every, calibrated, cpu_s));
      continue;
    }
    Result<Observer> given = product(kAsGiven, every, (*body)->rig().camera(), cpu_s);
    if (!given) return fail(given.error());
    observers.push_back(std::move(*given));
  }
  return observers;
}

/// Measures the rows of one floor and seed. Returns false when it was stopped.
Result<bool> measure(const floor::Scenario& scenario, const std::string& kind, std::uint64_t seed,
                     const OdometryOptions& options, const CpuTime& cpu_s, std::vector<Row>& rows) {
  const auto camera = floor::calibrated(scenario.for_calibration(), scenario.calibration_line());
  if (!camera) return fail(camera.error());
  if (!*camera) return false;
  for (const Rehearsed& rehearsed : drives_of(scenario, options)) {
    Result<std::vector<Observer>> observers = watchers(rehearsed, **camera, options, cpu_s);
    if (!observers) return fail(observers.error());
    const Result<bool> done = rehearse(rehearsed.drive, rehearsed.line, *observers);
    if (!done || !*done) return done;
    for (const Observer& observer : *observers)
      rows.push_back(row_of(kind, seed, named(rehearsed.name, observer.every()), observer));
  }
  return true;
}

}  // namespace

Result<Ended> study_odometry(const OdometryOptions& options, const Surroundings& around, const CpuTime& cpu_s) {
  const Result<floor::Subject> subject = floor::subject_of(options, around.asked_to_stop);
  if (!subject) return fail(subject.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  floor::Study study = subject->study;
  if (options.candidates) study.metres = kCandidatesOverM;
  Result<std::vector<Row>> read = read_odometry_rows(options.out, study);
  if (!read) return fail(read.error());
  std::vector<Row>& rows = *read;
  const auto is_there = [&rows](const std::string& kind, std::uint64_t seed) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Row& row) { return row.kind == kind && row.seed == seed; });
  };
  std::size_t kept = 0;
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed)
    for (const std::string& kind : subject->kinds) kept += is_there(kind, seed) ? 1 : 0;
  RowsMeasured progress(subject->kinds.size() * (options.seeds.last - options.seeds.first + 1), kept, around);
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const std::string& kind : subject->kinds) {
      if (is_there(kind, seed)) continue;
      const Result<floor::Scenario> scenario = floor::Scenario::make(subject->stage, kind, seed);
      if (!scenario) return fail(scenario.error());
      const Result<bool> done = measure(*scenario, kind, seed, options, cpu_s, rows);
      if (!done) return fail(done.error());
      if (!*done) return Ended::stopped;
      if (const Result<void> written = write_odometry_rows(options.out, study, rows); !written)
        return fail(written.error());
      progress.row(kind + ", seed " + std::to_string(seed));
    }
  }
  const std::vector<Region> regions = regions_of(rows);
  around.out << table_of(rows) << words_of(regions) << std::flush;
  return is_any_missed(regions) ? Ended::missed : Ended::complete;
}

}  // namespace weft::evaluate::odometry
