#include <string>

#include "clients/evaluate/invocation_words.hpp"
#include "clients/evaluate/topometric/trials.hpp"

namespace weft::evaluate {

CLI::App* describe(CLI::App& app, TopometricWords& words) {
  CLI::App* const sub = app.add_subcommand(
      "topometric",
      "How well the method topometric maps, finds itself, drives and avoids what stands in its way by a stereo pair "
      "alone, by its acceptance table, with the experiments of Dayoub et al. 2013: an office floor with plain walls "
      "and blackouts, deliveries, shortcuts, obstacles, robots put down anywhere, maps that meet "
      "(docs/topometric-study.md). Ends with 1 when something that is asked does not hold.\n"
      "Writes topometric.csv, topometric.json and pictures. Ctrl-C stops it; the same command goes on where it "
      "stopped.");
  words.seeds = "1..5";
  TopometricOptions& options = words.study;
  options.scenes = "deploy/sites/topometric";
  options.out = "out/topometric";
  const auto option = flags_of(sub);
  option(
      "--seeds", words.seeds, "A..B",
      "Seeds A to B, or one: each is another hand, calibration, light and noise; long trials take the first two or "
      "three of them [1..5]");
  const std::vector<std::string> trials = topometric::all_trials();
  std::string names;
  for (const std::string& trial : trials) names += (names.empty() ? "" : ", ") + trial;
  option("--trial", options.trial, "NAME", "Only this one: " + names + " [all but night]")
      ->check(CLI::IsMember(trials).description(""));
  option("--size", options.extent.width_px, "PIXELS", "How wide images of the pair are: 320 or 480 [320]")
      ->check(CLI::IsMember({320, 480}).description(""));
  sub->add_flag(
         "--quick", words.is_quick,
         "Seed 1, 70 m: deliveries, an obstacle, a shortcut, a map of two robots, held to what is asked of the "
         "worst seed: says within three minutes that it works")
      ->excludes(sub->get_option("--trial"));
  option("--scenes", options.scenes, "DIR", "Sites and lines that are driven [deploy/sites/topometric]");
  option("--out", options.out, "DIR", "Folder for the results; rows that it holds already are kept [out/topometric]");
  sub->add_flag("--json", options.is_json, "One line of JSON instead of the table");
  return sub;
}

}  // namespace weft::evaluate
