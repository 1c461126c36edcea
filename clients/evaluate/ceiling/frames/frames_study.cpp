#include "clients/evaluate/ceiling/frames/frames_study.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "clients/evaluate/ceiling/frames/frames_score.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::ceiling {
namespace {

std::string json_of(const FramesScore& score) {
  const nlohmann::ordered_json line = {
      {"frames", score.frames},           {"lost", score.lost},
      {"rms_heights", score.rms_heights}, {"rms_fitted_heights", score.rms_fitted_heights},
      {"yaw_deg", score.yaw_deg},         {"tilt_deg", score.tilt_deg},
      {"wrong_pairs", score.wrong_pairs}};
  return line.dump() + "\n";
}

std::string table_of(const FramesScore& score) {
  std::vector<std::vector<std::string>> rows = {
      {"measure", "value"},
      {"frames", std::to_string(score.frames)},
      {"lost", std::to_string(score.lost)},
      {"RMS against golden, ceiling heights", cell(score.rms_heights, 4)},
      {"with a scale fitted, ceiling heights", cell(score.rms_fitted_heights, 4)},
      {"heading, RMS, degrees", cell(score.yaw_deg, 2)},
      {"the camera leans by, degrees", cell(score.tilt_deg, 2)},
      {"pairs related without a guess", std::to_string(score.pairs)},
      {"accepted", std::to_string(score.accepted_pairs)},
      {"accepted and wrong", std::to_string(score.wrong_pairs)}};
  for (const auto& [reason, count] : score.refused) rows.push_back({"refused: " + reason, std::to_string(count)});
  return markdown_table(rows, 1);
}

}  // namespace

Result<Ended> study_frames(const CeilingFramesOptions& options, const Surroundings& around) {
  const Result<Recording> recording = read_recording(options.folder);
  if (!recording) return fail(recording.error());
  around.progress << "weft-evaluate: " << recording->frames.size() << " frames of " << options.folder.string() << '\n'
                  << std::flush;
  const Result<std::optional<FramesScore>> score = measure_frames(*recording, around.asked_to_stop);
  if (!score) return fail(score.error().code, options.folder.string() + ": " + score.error().message);
  if (!*score) return Ended::stopped;
  around.out << (options.json ? json_of(**score) : table_of(**score)) << std::flush;
  return Ended::complete;
}

}  // namespace weft::evaluate::ceiling
