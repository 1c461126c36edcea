#include "clients/evaluate/invocation_words.hpp"

namespace weft::evaluate {

CLI::App* describe(CLI::App& app, CeilingWords& words) {
  CLI::App* const sub = app.add_subcommand(
      "ceiling",
      "How well the method ceiling sees, maps, finds itself and follows lines, by its acceptance table: a recording "
      "of a real ceiling, lines and a loop in a simulated hall, robots that are put down anywhere; the baselines of "
      "Lucas et al. beside it (docs/ceiling-study.md). Ends with 1 when something that is asked does not hold.\n"
      "Writes ceiling.csv, ceiling.json and ceiling.png. Ctrl-C stops it; the same command goes on where it "
      "stopped.");
  words.seeds = "1..5";
  CeilingOptions& options = words.study;
  options.scenes = "deploy/sites/ceiling";
  options.recording = "../shared/data/ceiling-cycloid";
  options.out = "out/ceiling";
  const auto option = flags_of(sub);
  option("--seeds", words.seeds, "A..B",
         "Seeds A to B, or one: each is another hand, calibration, light and noise; the line is driven with as many "
         "more [1..5]");
  option("--metres", options.extent.metres, "M", "How much of the straight lines, 6 to 20 [20]")
      ->check(CLI::Range(6.0, 20.0).description(""));
  option("--put-downs", options.extent.put_downs, "N", "Robots put down, of each kind, with each seed [200]")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000}).description(""));
  option("--trial", options.trial, "TRIAL",
         "frames, line, other, change, loop, found, found-half or found-lamps: only that one")
      ->check(CLI::IsMember({"frames", "line", "other", "change", "loop", "found", "found-half", "found-lamps"})
                  .description(""));
  sub->add_flag("--quick", words.is_quick,
                "The recording; seed 1, 8 m of line, 40 robots put down on it: says within three minutes that it "
                "works")
      ->excludes(sub->get_option("--trial"));
  option("--scenes", options.scenes, "DIR", "Sites and lines that are driven [deploy/sites/ceiling]");
  option("--recording", options.recording, "DIR",
         "Recording as of ceiling-frames; where there is none, its rows are not measured "
         "[../shared/data/ceiling-cycloid]");
  option("--out", options.out, "DIR", "Folder for the results; rows that it holds already are kept [out/ceiling]");
  return sub;
}

CLI::App* describe(CLI::App& app, CeilingFramesOptions& options) {
  CLI::App* const sub = app.add_subcommand(
      "ceiling-frames",
      "How well the method ceiling sees a recording of a camera that looks up, against another tracker's poses, in "
      "heights of the ceiling; how the camera leans is found from the images (docs/ceiling-study.md).\n"
      "Prints a table: RMS with and without a scale fitted, heading, tilt, frames lost, pairs related and wrong.");
  sub->add_option("DIR", options.folder, "Folder with frames_*.raw.gz, golden_*.txt and ceiling.toml")
      ->required()
      ->type_name("");
  sub->add_flag("--json", options.json, "One line of JSON instead of the table");
  return sub;
}

}  // namespace weft::evaluate
