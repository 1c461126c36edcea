#include "clients/cli/grammar.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>

namespace weft::cli {

void Grammar::rules() {
  CLI::App* const rules = group("rule", "What is laid down for pieces of the map");
  CLI::App* const added = add(*rules, "add", "Lay down a rule, or change the one of that name", Command::rule_add);
  added->add_option("NAME", into_.rule.name, rule("Its name"))->required()->type_name("");
  added
      ->add_option_function<std::string>(
          "--kind", [this](const std::string& text) { read_kind(text); },
          "closed | speed=M/S | one_way | priority=N | capacity=N | parking | charging | hold")
      ->required()
      ->type_name("KIND");
  added
      ->add_option("--place", into_.stretches,
                   "Where: places E:I..J of a run (E: 16 hex digits), E:I..F:J over an edge, or E:I; repeatable")
      ->allow_extra_args(false)
      ->type_name("A..B");
  CLI::Option* const label = added->add_option("--label", into_.rule.label, "Where: at a label")->type_name("LABEL");
  added->add_option("--within", into_.rule.within_m, "And around it, metres along the ways from and to it [0]")
      ->type_name("M")
      ->check(CLI::Range(0.0, kRuleWithin_m).description(""))
      ->needs(label);
  CLI::Option* const polygon =
      added
          ->add_option_function<std::string>(
              "--polygon",
              [this](const std::string& text) {
                Result<Polygon> read = parse_polygon(text);
                if (!read) throw CLI::ValidationError("--polygon " + read.error().message);
                into_.polygon = *std::move(read);
              },
              "Where: on the places that lie within these corners of a registered floor plan, or on either side of "
              "them, as the map is now; see weft rule refresh")
          ->type_name("X,Y;X,Y;...");
  added->add_option("--plan", into_.plan, "With --polygon: which plan [the only one that is registered]")
      ->type_name("NAME")
      ->needs(polygon);
  added->add_flag("--one-direction", into_.rule.one_direction, "With closed: only from A towards B");
  only_say(*added);
  add(*rules, "list", "All rules, on how many places each holds, and what of its polygon it does not cover",
      Command::rule_list);
  refreshing(*rules);
  CLI::App* const removed = add(*rules, "remove", "Take a rule away", Command::rule_remove);
  removed->add_option("NAME", into_.rule.name, "The rule")->required()->type_name("");
  only_say(*removed);
  CLI::App* const edge = group("edge", "The way from a place to another one");
  one_edge(*edge, "close", "Let nobody drive from A to B any more: a rule, see weft rule list", Command::edge_close);
  one_edge(*edge, "open", "Let robots drive there again", Command::edge_open);
  held(app_, "hold", "Release a ROBOT, or robots on the places of a RULE, no farther; nobody stops harder for it",
       Command::hold);
  held(app_, "unhold", "Let a held ROBOT, or the places of a RULE, go", Command::unhold);
}

void Grammar::refreshing(CLI::App& parent) {
  CLI::App* const sub =
      add(parent, "refresh", "Cover what lies within a rule's polygon by now, and no more", Command::rule_refresh);
  CLI::Option* const name = sub->add_option("NAME", into_.rule.name, "The rule")->type_name("");
  CLI::Option* const all = sub->add_flag("--all", all_, "Every rule with a polygon");
  name->excludes(all);
  only_say(*sub);
  // Takes the place of the callback that add() gave.
  sub->callback([this, sub] {
    into_.command = Command::rule_refresh;
    if (into_.rule.name.empty() && !all_) throw CLI::RequiredError(sub->get_name() + ": NAME or --all");
  });
}

void Grammar::one_edge(CLI::App& parent, const char* name, const char* help, Command command) {
  CLI::App* const sub = add(parent, name, help, command);
  sub->add_option("A", into_.place, "A place E:I (E: 16 hex digits)")->required()->type_name("");
  sub->add_option("B", into_.to_place, "A place of the same run, or one that an edge joins it with")
      ->required()
      ->type_name("");
  sub->add_flag("--both", into_.both, "In both directions");
}

void Grammar::held(CLI::App& parent, const char* name, const char* help, Command command) {
  add(parent, name, help, command)
      ->add_option("WHAT", into_.robot, "A robot's name or id, or a rule's name")
      ->required()
      ->type_name("");
}

void Grammar::read_kind(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::optional<RuleKind> kind = rule_kind(text.substr(0, equals));
  if (!kind) {
    throw CLI::ValidationError(
        "--kind " + text +
        " is none of: closed, speed=M/S, one_way, priority=N, capacity=N, parking, charging, hold");
  }
  into_.rule.kind = *kind;
  const bool needs_value = *kind == RuleKind::speed || *kind == RuleKind::priority || *kind == RuleKind::capacity;
  if (needs_value != (equals != std::string::npos)) {
    throw CLI::ValidationError("--kind " + text + (needs_value ? " needs a value: " : " takes no value: ") +
                               to_string(*kind) + (needs_value ? "=0.5, say" : ""));
  }
  if (!needs_value) return;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, into_.rule.value);
  if (error != std::errc{} || stop != end) {
    throw CLI::ValidationError("--kind " + text + ": '" + text.substr(equals + 1) + "' is no number");
  }
}

}  // namespace weft::cli
