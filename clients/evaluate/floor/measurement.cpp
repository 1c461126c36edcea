#include "clients/evaluate/floor/measurement.hpp"

#include "clients/evaluate/floor/calibrated.hpp"

namespace weft::evaluate::floor {

Result<Ended> Measurement::mapping() {
  const double began_s = around_.steady_s();
  if (const Result<Ended> ended = teach_once(); !ended || *ended == Ended::stopped) return ended;
  const Result<std::optional<Trace>> wrong_mount = lead(scenario_.with_wrong_mount(), scenario_.line());
  if (!wrong_mount) return fail(wrong_mount.error());
  if (!*wrong_mount) return Ended::stopped;
  Drive quick = scenario_.fast();
  quick.camera = camera_;
  const Result<std::optional<Trace>> fast = lead(quick, scenario_.fast_line());
  if (!fast) return fail(fast.error());
  if (!*fast) return Ended::stopped;
  return keep(kMapping, score_of_mapping(taught_.traces.front(), **wrong_mount, **fast), began_s);
}

Result<Ended> Measurement::repeat_under(const std::string& light) {
  const double began_s = around_.steady_s();
  if (const Result<Ended> ended = teach_once(); !ended || *ended == Ended::stopped) return ended;
  const Result<Drive> drive = scenario_.second(light);
  if (!drive) return fail(drive.error());
  const Result<std::optional<Repeated>> repeated = repeat(*drive, taught_);
  if (!repeated) return fail(repeated.error());
  if (!*repeated) return Ended::stopped;
  if (const Result<void> shelved = shelve(light, (*repeated)->trace); !shelved) return fail(shelved.error());
  return keep(light, score_of_repeat(taught_, **repeated), began_s);
}

Result<Ended> Measurement::calibrate_once() {
  if (camera_) return Ended::complete;
  Result<std::optional<agents::CameraModel>> found =
      calibrated(scenario_.for_calibration(), scenario_.calibration_line());
  if (!found) return fail(found.error());
  camera_ = std::move(*found);
  return camera_ ? Ended::complete : Ended::stopped;
}

Result<Ended> Measurement::teach_once() {
  if (!taught_.traces.empty()) return Ended::complete;
  if (const Result<Ended> ended = calibrate_once(); !ended || *ended == Ended::stopped) return ended;
  Drive first = scenario_.first();
  first.camera = camera_;
  const Result<bool> taught = teach(first, scenario_.line(), taught_);
  if (!taught) return fail(taught.error());
  if (!*taught) return Ended::stopped;
  if (const Result<void> shelved = shelve(kTaughtRun, taught_.traces.front()); !shelved) {
    return fail(shelved.error());
  }
  return Ended::complete;
}

Result<void> Measurement::shelve(const std::string& what, const Trace& trace) const {
  return all_runs_ ? shelf_.keep(what, trace) : Result<void>();
}

Result<Ended> Measurement::keep(const std::string& part, Score score, double began_s) {
  score.seconds = around_.steady_s() - began_s;
  if (const Result<void> kept = keep_({shelf_.kind, part, shelf_.seed}, score); !kept) return fail(kept.error());
  return Ended::complete;
}

}  // namespace weft::evaluate::floor
