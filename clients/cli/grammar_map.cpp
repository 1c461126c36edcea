#include "clients/cli/grammar.hpp"

#include <CLI/CLI.hpp>
#include <utility>

namespace weft::cli {

void Grammar::map() {
  CLI::App* const map = group("map", "The network");
  add(*map, "info", "How much there is, and what was refused", Command::map_info);
  add(*map, "list", "What was taught and imported: by whom, when, how long, its labels, what it is joined to",
      Command::map_list);
  CLI::App* const draw =
      add(*map, "draw", "Draw the network: runs, stitches, labels, and what each line means", Command::map_draw);
  draw->add_option("OUT", into_.file, "A file, *.png or *.svg")->type_name("")->required();
  CLI::Option* const ground =
      draw->add_option("--floor-plan", into_.floor_plan,
                       "Draw it upon a floor plan: a map_server file, with its PGM; registered, or with --anchor")
          ->type_name("MAP.yaml");
  anchors(*draw);
  CLI::Option* const robots = draw->add_flag("--robots", into_.draws_robots,
                                             "Robots too, where they say they are, what they hold, and their routes");
  revision(*draw, "--at", into_.at, "As the network was at that revision")->excludes(robots);
  mosaic(*draw, *ground, *robots);
  CLI::App* const label = add(*map, "label", "Name a place, to send goals to", Command::map_label);
  label->add_option("PLACE", into_.place, "A place's id as `weft map export` writes it, or: here")
      ->type_name("")
      ->required();
  label->add_option("NAME", into_.name, rule("The label"))->type_name("")->required();
  label->add_option("--robot", into_.robot, "With here: the robot that stands there")->type_name("ROBOT");
  label->callback([this] {
    into_.command = Command::map_label;
    const bool here = into_.place == "here";
    if (here && into_.robot.empty()) throw CLI::RequiredError("map label here: --robot ROBOT");
    if (!here && !into_.robot.empty())
      throw CLI::ValidationError("map label PLACE NAME: --robot goes with here only");
  });
  add(*map, "unlabel", "Remove a label; the place stays", Command::map_unlabel)
      ->add_option("NAME", into_.name, "The label")
      ->type_name("")
      ->required();
  CLI::App* const relabel = add(*map, "relabel", "Call a label otherwise", Command::map_relabel);
  relabel->add_option("NAME", into_.name, "The label")->type_name("")->required();
  relabel->add_option("NEW", into_.new_name, rule("Its new name"))->type_name("")->required();
  CLI::App* const exported = add(*map, "export", "Write the network into a file", Command::map_export);
  exported
      ->add_option("OUT", into_.file,
                   "*.g2o | *.geojson (Nav2 route graph) | *.dot | *.graphml | *.tum | *.pcd and *.ply (the clouds "
                   "of places); "
                   "any other name: JSON")
      ->type_name("")
      ->required();
  exported
      ->add_option("--experience", into_.experience,
                   "With *.tum: which, by its name, or its id or the beginning of that")
      ->type_name("NAME");
  anchors(*exported);
  CLI::Option* const plan =
      exported
          ->add_option(
              "--plan", into_.plan,
              "In the frame of that registered floor plan [*.geojson, *.tum, *.pcd and *.ply: of the only one]")
          ->type_name("NAME");
  exported->add_flag("--no-plan", into_.no_plan, "In a frame of its own, all parts, although a plan is registered")
      ->excludes(plan);
  revision(*exported, "--at", into_.at, "As the network was at that revision");
  CLI::App* const import =
      add(*map, "import", "Add the network of pose graphs; nobody drives there", Command::map_import);
  import->add_option("FILE", into_.files, "*.g2o; several of one graph are joined")->type_name("")->required();
  import->add_option("--as", into_.name, rule("The import's name, under which it is a repeat"))
      ->type_name("NAME")
      ->required();
  registering(*map);
  past(*map);
  edits(*map);
  upkeep(*map);
}

void Grammar::mosaic(CLI::App& draw, CLI::Option& ground, CLI::Option& robots) {
  CLI::Option* const mosaic =
      draw.add_flag("--mosaic", into_.draws_mosaic,
                    "Instead: what places show of the ceiling, laid together, in the frame of the registered floor "
                    "plan if there is one; with labels and a scale")
          ->excludes(&ground)
          ->excludes(&robots);
  CLI::Option* const clouds =
      draw.add_flag("--clouds", into_.draws_clouds,
                    "Instead: the clouds of places, laid together, as seen from above, in the same frame")
          ->excludes(&ground)
          ->excludes(&robots)
          ->excludes(mosaic);
  CLI::Option* const plan =
      draw.add_option("--plan", into_.plan, "With --mosaic or --clouds: in the frame of that one")->type_name("NAME");
  CLI::Option* const no_plan =
      draw.add_flag("--no-plan", into_.no_plan, "With --mosaic or --clouds: in a frame of its own, all parts")
          ->excludes(plan);
  // Takes the place of the callback that add() gave.
  draw.callback([this, mosaic, clouds, plan, no_plan] {
    into_.command = Command::map_draw;
    const bool has_frame = plan->count() > 0 || no_plan->count() > 0;
    if (has_frame && mosaic->count() == 0 && clouds->count() == 0)
      throw CLI::RequiresError(plan->count() > 0 ? "--plan" : "--no-plan", "--mosaic or --clouds");
  });
}

void Grammar::past(CLI::App& map) {
  CLI::App* const log = add(map, "log", "What each revision changed, when, and who asked", Command::map_log);
  revision(*log, "--newest", into_.to, "Begin with that revision [the latest]");
  log->add_option("--most", into_.most, "How many, 1 to 1000 [20]")
      ->type_name("N")
      ->check(CLI::Range(1U, 1000U).description(""));
  CLI::App* const diff = add(map, "diff", "What came and what went from revision A to B", Command::map_diff);
  revision(*diff, "A", into_.from, "A revision, as `weft map log` shows it")->required()->type_name("");
  revision(*diff, "B", into_.to, "Another one [the latest]")->type_name("");
  diff->add_option("--draw", into_.file, "A picture of it, *.png or *.svg")->type_name("OUT");
}

CLI::Option* Grammar::revision(CLI::App& sub, const char* name, Revision& into, const char* help) {
  return sub.add_option(name, into.value, help)
      ->type_name("REVISION")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62U).description(""));
}

void Grammar::anchors(CLI::App& sub) {
  anchor_option(
      sub, "--anchor",
      "Where a label lies in the site's frame, metres and radians; repeatable. One needs a heading; several "
      "are fitted by their positions");
}

CLI::Option* Grammar::anchor_option(CLI::App& sub, const char* name, const char* help) {
  return sub
      .add_option_function<std::vector<std::string>>(
          name,
          [this, name](const std::vector<std::string>& given) {
            for (const std::string& text : given) {
              Result<Anchor> anchor = parse_anchor(text);
              if (!anchor) throw CLI::ValidationError(std::string(name) + " " + anchor.error().message);
              into_.anchors.push_back(*std::move(anchor));
            }
          },
          help)
      ->type_name("LABEL=X,Y[,HEADING]");
}

}  // namespace weft::cli
