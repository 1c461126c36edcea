#include <CLI/CLI.hpp>
#include <cmath>

#include "clients/cli/grammar.hpp"
#include "storage/formats/lines.hpp"

namespace weft::cli {

void Grammar::registering(CLI::App& map) {
  CLI::App* const sub =
      add(map, "register", "Say where labels lie on a floor plan: robots, pictures and exports are placed on it",
          Command::map_register);
  sub->add_option("PLAN", into_.floor_plan, "A map_server file with its PGM or PNG; its name is the plan's")
      ->type_name("");
  CLI::Option* const picks =
      anchor_option(*sub, "--pick",
                    "Where a label, or a place E:I, lies on the plan, metres and radians; repeatable. Two lie 1 m "
                    "apart or more, or "
                    "one has a heading; of four or more, one that contradicts the others is named and left out");
  CLI::Option* const sigma = sub->add_option("--sigma", into_.sigma_m, "How exactly they were picked, metres [0.05]")
                                 ->type_name("M")
                                 ->check(CLI::Range(kLeastPickSigma_m, kMostPickSigma_m).description(""))
                                 ->needs(picks);
  CLI::Option* const show =
      sub->add_flag("--show", into_.lists, "Say what is registered, PLAN alone if it is given, and how well it fits");
  CLI::Option* const remove = sub->add_flag("--remove", into_.removes, "Register the plan no longer");
  show->excludes(picks)->excludes(remove)->excludes(sigma);
  remove->excludes(picks);
  only_say(*sub);
  sub->callback([this] {
    into_.command = Command::map_register;
    if (into_.lists || into_.removes) return;
    if (into_.floor_plan.empty() || into_.anchors.empty())
      throw CLI::RequiredError("map register: PLAN and --pick LABEL=X,Y, or --show, or --remove");
  });
}

void Grammar::to_plan(CLI::App& send) {
  CLI::Option* const label = send.get_option("--to");
  CLI::Option* const point =
      send.add_option_function<std::string>(
              "--to-plan",
              [this](const std::string& text) {
                const std::vector<std::string_view> numbers = formats::cells_of(text, ',');
                const auto x = numbers.size() == 2 ? formats::parse_finite(numbers[0]) : std::nullopt;
                const auto y = numbers.size() == 2 ? formats::parse_finite(numbers[1]) : std::nullopt;
                const auto is_within = [](double value) { return std::abs(value) <= kPlanReach_m; };
                if (!x || !y || !is_within(*x) || !is_within(*y)) {
                  throw CLI::ValidationError("--to-plan '" + text +
                                             "' is no point: write X,Y, metres in the registered plan's frame");
                }
                into_.to_plan = Eigen::Vector2d(*x, *y);
              },
              "Where: a point of a registered floor plan, metres; the nearest place within 0.5 m")
          ->type_name("X,Y")
          ->excludes(label);
  send.add_option("--plan", into_.plan, "With --to-plan: which plan [the only one that is registered]")
      ->type_name("NAME")
      ->needs(point);
  send.callback([this] {
    into_.command = Command::goal_send;
    if (into_.name.empty() && !into_.to_plan) throw CLI::RequiredError("goal send: --to LABEL or --to-plan X,Y");
  });
}

}  // namespace weft::cli
