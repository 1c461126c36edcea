#include <map>
#include <string>

#include "clients/evaluate/invocation_words.hpp"

namespace weft::evaluate {

CLI::App* describe(CLI::App& app, DisturbancesOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "disturbances",
      "What each disturbance of the simulated body costs the method floor in accuracy: one robot is led along a "
      "line, "
      "another looks for its places a day later, under the site's disturbances, none, all but one, and one alone; "
      "then "
      "with an uneven floor, a rolling shutter and late stamps as well.\n"
      "Writes disturbances.csv, .json and .png. Ctrl-C stops it; the same command goes on where it stopped.");
  seeds = "1..3";
  options.site = "deploy/sites/demo.toml";
  options.out = "out/disturbances";
  const auto option = flags_of(sub);
  option("--seeds", seeds, "A..B", "Seeds A to B, or one: each is another wear, calibration and noise [1..3]");
  option("--site", options.site, "FILE",
         "Site file: the floor, the robot (its first one), how large each disturbance is [deploy/sites/demo.toml]");
  option("--along", options.along, "FILE",
         "Line to be led along, 'x y' a row in metres [r1.line in the folder named like the site, beside it]");
  option("--metres", options.metres, "M", "How much of the line, 11 to 1000 [12]")
      ->check(CLI::Range(11.0, 1000.0).description(""));
  option("--only", options.only, "NAME",
         "Only this row of the table, or the rows of this disturbance; can be given again; a wrong name lists them "
         "[all]")
      ->allow_extra_args(false);
  option("--out", options.out, "DIR",
         "Folder for the results; rows that it holds already are kept [out/disturbances]");
  return sub;
}

CLI::App* describe(CLI::App& app, BearingWords& words) {
  CLI::App* const sub = app.add_subcommand(
      "bearing",
      "How well the method bearing comes back to a way that it was taught, in the experiments of Krajnik et al. "
      "2018: "
      "an oval of 10 m and a lemniscate of 17 m begun 1 m off, 60 m by day, in the dark and with half of the lamps, "
      "bad "
      "wheels, changed stock; each half of the method alone; the first loop against the paper's model.\n"
      "Writes bearing.csv, bearing.json and four pictures. Ctrl-C stops it; the same command goes on where it "
      "stopped.");
  words.seeds = "1..2";
  BearingOptions& options = words.study;
  options.scenes = "deploy/sites/bearing";
  options.out = "out/bearing";
  const auto option = flags_of(sub);
  option("--seeds", words.seeds, "A..B",
         "Seeds A to B, or one: each is another hand, calibration, light and noise [1..2]");
  option("--trial", options.trial, "NAME", "Only this one; a wrong name lists them [all]");
  sub->add_flag("--quick", words.is_quick, "One trial, seed 1: says within three minutes that it works");
  option("--scenes", options.scenes, "DIR", "Sites and lines that are driven [deploy/sites/bearing]");
  option("--out", options.out, "DIR", "Folder for the results; rows that it holds already are kept [out/bearing]");
  return sub;
}

CLI::App* describe(CLI::App& app, BearingRelocaliseWords& words) {
  CLI::App* const sub = app.add_subcommand(
      "bearing-relocalise",
      "Whether a robot that knows nothing of where it is takes a place for another one (method bearing): aisles that "
      "look alike are taught, and another robot is put down among them on another day, in other light, and led until "
      "it believes to know where it is; also in aisles that hold the same, or that were not taught. Ends with 1 when "
      "one was wrong, or too few found themselves.\n"
      "Writes relocalise.csv, relocalise.json and bearing-relocalise.png (docs/bearing-study.md). Ctrl-C stops it; "
      "the "
      "same command goes on where it stopped.");
  words.seeds = "1..4";
  BearingRelocaliseOptions& options = words.study;
  options.site = "deploy/sites/bearing/yard.toml";
  options.out = "out/bearing-relocalise";
  const auto option = flags_of(sub);
  option("--seeds", words.seeds, "A..B",
         "Seeds A to B, or one: each is other loads, another hand, calibration, light and noise [1..4]");
  option("--kind", options.kind, "NAME", "Only this kind of aisles; a wrong name lists them [all]");
  option("--trials", options.trials, "N", "How many, of each kind, light and seed [11]")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}).description(""));
  sub->add_flag("--quick", words.is_quick, "Seed 1, 2 trials each: says within three minutes that it works");
  option("--site", options.site, "FILE",
         "Site file: the robot (its first one), its camera, how large the disturbances are "
         "[deploy/sites/bearing/yard.toml]");
  option("--out", options.out, "DIR",
         "Folder for the results; trials that it holds already are kept [out/bearing-relocalise]");
  return sub;
}

CLI::App* describe(CLI::App& app, LearningOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "learning",
      "What it is worth that places of the method bearing learn from robots that come by: a way is taught, then "
      "driven "
      "once a day while the stock changes, day and dark alternate, or nothing changes; with learning and without.\n"
      "Prints a table and writes learning.csv.");
  seeds = "1..3";
  options.line = "lemniscate";
  options.scenes = "deploy/sites/bearing";
  options.out = "out/learning";
  const auto option = flags_of(sub);
  option("--seeds", seeds, "A..B", "Seeds A to B, or one: each is another hand, calibration, light and noise [1..3]");
  option("--days", options.days, "NAME", "Only these; a wrong name lists them [all]");
  option("--line", options.line, "NAME", "The way: NAME.line in the site NAME.toml [lemniscate]");
  option("--scenes", options.scenes, "DIR", "Sites and lines that are driven [deploy/sites/bearing]");
  option("--out", options.out, "DIR", "Folder for learning.csv [out/learning]");
  return sub;
}

CLI::App* describe(CLI::App& app, HeadingOptions& options) {
  CLI::App* const sub = app.add_subcommand(
      "heading",
      "How well the most frequent shift of what two views both show (method bearing) tells the heading between "
      "images "
      "of one place in other seasons, against shifts that somebody found by hand: folders in GRIEF's two layouts "
      "(docs/bearing-study.md).\n"
      "Prints a table: pairs, how many are right within 35 pixels, median error, refused.");
  sub->add_option("DIR", options.folder, "Folder with ground_truth/ and images/, or with displacements.txt")
      ->required()
      ->type_name("");
  const std::map<std::string, agents::Description> features = {{"brief", agents::Description::brief},
                                                               {"gradients", agents::Description::gradients}};
  sub->add_option("--feature", options.feature, "What is compared: brief or gradients [gradients]")
      ->transform(CLI::CheckedTransformer(features).description(""))
      ->type_name("NAME");
  sub->add_option("--features", options.features, "Of an image at most, 20 to 5000; robots drive with 300 [2000]")
      ->check(CLI::Range(20, 5000).description(""))
      ->type_name("N");
  sub->add_option(
         "--cell", options.cell_widths,
         "Of the 4 x 4 cells that a feature is described by, each is so wide, 0.005 to 0.05 of the image; robots "
         "drive with 0.022 [0.0156]")
      ->check(CLI::Range(0.005, 0.05).description(""))
      ->type_name("SHARE");
  sub->add_flag("--json", options.json, "One line of JSON instead of the table");
  return sub;
}

CLI::App* describe(CLI::App& app, GenerateOptions& generate) {
  CLI::App* const sub = app.add_subcommand(
      "generate-site",
      "A store with a large site that many robots have driven in, to see how what is built for one bears it.\n"
      "Prints progress. Ctrl-C stops it; the same command goes on where it stopped.");
  generate.out = "out/site";
  const auto option = flags_of(sub);
  option("--places", generate.plan.places, "N", "How many places, 1 to 10000000 [10000]");
  option("--seed", generate.plan.seed, "N", "Another seed is another site [1]");
  option("--content-bytes", generate.plan.content_bytes, "N", "Content of each place, 8 to 1000000 [64]");
  option("--out", generate.out, "DIR", "The store's directory [out/site]");
  return sub;
}

}  // namespace weft::evaluate
