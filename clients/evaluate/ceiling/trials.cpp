#include "clients/evaluate/ceiling/trials.hpp"

#include <utility>

#include "clients/evaluate/ceiling/calibrated.hpp"
#include "clients/evaluate/ceiling/found_trial.hpp"
#include "clients/evaluate/ceiling/frames/frames_score.hpp"
#include "clients/evaluate/ceiling/line_trials.hpp"
#include "clients/evaluate/ceiling/loop_trial.hpp"

namespace weft::evaluate::ceiling {

std::vector<std::string> driven_trials(const Extent& extent) {
  if (extent.is_quick) return {trial::kLine, trial::kFound};
  return {trial::kLine,  trial::kOther,     trial::kChange,    trial::kLoop,
          trial::kFound, trial::kFoundHalf, trial::kFoundLamps};
}

SeedTrials::SeedTrials(const Scenes& scenes, const Extent& extent, std::uint64_t seed, std::filesystem::path scratch,
                       std::function<bool()> asked_to_stop)
    : scenes_(scenes), extent_(extent) {
  driven_.seed = seed;
  driven_.scratch = std::move(scratch);
  driven_.asked_to_stop = std::move(asked_to_stop);
}

Result<bool> SeedTrials::teach_once(const Scene& scene, Taught& way) const {
  if (way) return true;
  const auto given = calibrated(scenes_, scene.site, driven_);
  if (!given) return fail(given.error());
  if (!*given) return false;
  Result<std::optional<Way>> taught = teach_way(scene, driven_, **given);
  if (!taught) return fail(taught.error());
  way = std::move(*taught);
  return way.has_value();
}

Result<std::optional<Measured>> SeedTrials::found(const std::string& trial, const Way& way) const {
  constexpr double half = 0.5;
  return measure_found(way, driven_, {extent_.put_downs, trial == trial::kFoundHalf ? half : 0.0}, scenes_);
}

Result<std::optional<Measured>> SeedTrials::measure(const std::string& trial) {
  const bool is_found = trial == trial::kFound || trial == trial::kFoundHalf;
  const bool is_on_loop = trial == trial::kLoop || (is_found && !extent_.is_quick);
  const bool is_below_lamps = trial == trial::kFoundLamps;
  Taught& way = is_below_lamps ? lamps_ : is_on_loop ? loop_ : line_;
  const Scene& scene = is_below_lamps ? scenes_.lamps : is_on_loop ? scenes_.loop : scenes_.straight;
  const Result<bool> taught = teach_once(scene, way);
  if (!taught) return fail(taught.error());
  if (!*taught) return std::optional<Measured>();
  if (trial == trial::kLine) return measure_line(*way, driven_);
  if (trial == trial::kOther) return measure_other(*way, driven_, scenes_);
  if (trial == trial::kChange) return measure_change(*way, driven_);
  if (trial == trial::kLoop) return std::optional(measure_loop(*way));
  return found(trial, *way);
}

Result<std::optional<Measured>> measure_recording(const std::filesystem::path& folder,
                                                  const std::function<bool()>& asked_to_stop) {
  const Result<Recording> recording = read_recording(folder);
  if (!recording) return fail(recording.error());
  const Result<std::optional<FramesScore>> score = measure_frames(*recording, asked_to_stop);
  if (!score) return fail(score.error().code, folder.string() + ": " + score.error().message);
  if (!*score) return std::optional<Measured>();
  const Result<std::optional<Tracked>> untilted = track(*recording, recording->camera, asked_to_stop);
  if (!untilted) return fail(untilted.error());
  if (!*untilted) return std::optional<Measured>();
  const FramesScore straight = score_of(*recording, **untilted, recording->camera);
  const FramesScore& ours = **score;
  Measured measured;
  measured.score.values = {{"frames", static_cast<double>(ours.frames)},
                           {"lost", static_cast<double>(ours.lost)},
                           {"rms_heights", ours.rms_heights},
                           {"rms_fitted_heights", ours.rms_fitted_heights},
                           {"yaw_deg", ours.yaw_deg},
                           {"tilt_deg", ours.tilt_deg},
                           {"pairs", static_cast<double>(ours.pairs)},
                           {"accepted_pairs", static_cast<double>(ours.accepted_pairs)},
                           {"wrong_pairs", static_cast<double>(ours.wrong_pairs)},
                           {"untilted_lost", static_cast<double>(straight.lost)},
                           {"untilted_rms_heights", straight.rms_heights},
                           {"untilted_rms_fitted_heights", straight.rms_fitted_heights},
                           {"untilted_yaw_deg", straight.yaw_deg}};
  const auto ambiguous = ours.refused.find("ambiguous");
  measured.score.values["ambiguous_pairs"] =
      ambiguous == ours.refused.end() ? 0.0 : static_cast<double>(ambiguous->second);
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::ceiling
