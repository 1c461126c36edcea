#include "clients/cli/invocation.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <system_error>

#include "clients/cli/grammar.hpp"
#include "core/names.hpp"
#include "core/polyline.hpp"
#include "core/text.hpp"

namespace weft::cli {
namespace {

using Command = Invocation::Command;

constexpr unsigned kLastDomain = 200;

/// Refuses names of a command line that the server would refuse, or could not read, before they leave this machine.
Result<void> check_names(const Invocation& invocation) {
  constexpr std::array kOfLabels = {Command::map_label, Command::goal_send, Command::map_unlabel,
                                    Command::map_relabel};
  const bool is_label = std::ranges::find(kOfLabels, invocation.command) != kOfLabels.end();
  const char* const kind = is_label ? "label" : invocation.command == Command::robot_rename ? "robot" : "name";
  if (!invocation.robot.empty()) {
    if (Result<void> good = check_name("robot", invocation.robot); !good) return good;
  }
  if (!invocation.name.empty()) {
    if (Result<void> good = check_name(kind, invocation.name); !good) return good;
  }
  if (!invocation.rule.name.empty()) {
    if (Result<void> good = check_name("rule", invocation.rule.name); !good) return good;
  }
  if (!invocation.rule.label.empty()) {
    if (Result<void> good = check_name("label", invocation.rule.label); !good) return good;
  }
  if (!invocation.new_name.empty()) {
    if (Result<void> good = check_name("label", invocation.new_name); !good) return good;
  }
  if (!invocation.plan.empty()) {
    if (Result<void> good = check_name("plan", invocation.plan); !good) return good;
  }
  constexpr const char* of_kinds = "abcdefghijklmnopqrstuvwxyz_.";
  const std::string& kind_of_events = invocation.event_kind;
  if (kind_of_events.size() > kLongestName || kind_of_events.find_first_not_of(of_kinds) != std::string::npos) {
    return fail(ErrorCode::invalid, "--kind " + cited(kind_of_events) +
                                        ": kinds of events are words with dots, as goal.assigned or goal; `weft "
                                        "events` shows them");
  }
  const bool names_label = invocation.command == Command::localise && !invocation.place.empty() &&
                           !parse_place_id(invocation.place).has_value();
  return names_label ? check_name("label", invocation.place) : Result<void>();
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

/// Returns the domain that the environment names; 0 when it names none, nothing when it is not one.
std::optional<unsigned> domain_of(const std::string& text) {
  unsigned domain = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (text.empty()) return 0U;
  if (problem != std::errc() || end != text.data() + text.size() || domain > kLastDomain) return std::nullopt;
  return domain;
}

/// Returns one line. CLI11 reports a missing subcommand before what stood in its place; the latter helps most.
std::string mistake(const CLI::App& app, const CLI::ParseError& problem) {
  const std::vector<std::string> strays = app.remaining(true);
  std::string what = problem.what();
  if (!strays.empty() && what.find(strays.front()) == std::string::npos) {
    what = "'" + strays.front() + "' is not understood here (" + what + ")";
  }
  return "weft: " + what + "; see weft --help\n";
}

}  // namespace

std::variant<Invocation, NotRun> parse(int argc, const char* const* argv, const Environment& environment) {
  Invocation invocation;
  if (argc > 1 && std::string_view(argv[1]) == "calibrate") {  // its words are the other program's to understand
    invocation.command = Command::calibrate;
    invocation.passed.assign(argv + 2, argv + argc);
    return invocation;
  }
  invocation.vendor = environment.vendor.empty() ? "cyclonedds" : environment.vendor;
  invocation.servers = split(environment.server, ',');
  invocation.listen = environment.listen.empty() ? "127.0.0.1" : environment.listen;
  const std::optional<unsigned> domain = domain_of(environment.domain);
  CLI::App app("The operator's command: talks to the fleet map server, weft-server.", "weft");
  app.require_subcommand(1);
  app.fallthrough();
  Grammar grammar(app, invocation);
  grammar.all();
  const bool wants_json =
      std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
  app.set_version_flag("--version", "weft " WEFT_VERSION + environment.libraries);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(problem, out, err) == 0) return NotRun{0, out.str()};
    return NotRun{2, mistake(app, problem), wants_json};
  }
  if (app.count("--domain") == 0) {
    if (!domain) {
      return NotRun{2, "weft: WEFT_DOMAIN is '" + environment.domain + "', which is no number from 0 to 200\n",
                    wants_json};
    }
    invocation.domain = *domain;
  }
  if (const Result<void> good = check_names(invocation); !good) {
    return NotRun{2, "weft: " + good.error().message + "\n", wants_json};
  }
  if (invocation.servers.empty()) invocation.servers.emplace_back("127.0.0.1");
  return invocation;
}

Result<std::vector<msg::AgentCommand::Point>> parse_polyline(std::string_view text, const std::string& file) {
  const Result<std::vector<PolylinePoint>> read = parse_polyline_points(text, file);
  if (!read) return fail(read.error());
  if (read->size() < 2) return fail(ErrorCode::invalid, file + ": fewer than two points, nothing to drive along");
  std::vector<msg::AgentCommand::Point> points;
  for (const auto& [x, y] : *read) points.push_back({x, y});
  return points;
}

}  // namespace weft::cli
