#include "server/process/options.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <sstream>
#include <utility>

#include "core/exit_code.hpp"
#include "core/text.hpp"
#include "process/settings_file.hpp"
#include "server/dispatcher/charge.hpp"

namespace weft::server {
namespace {

/// Holds settings as given on the command line; none: not given.
struct Flags {
  std::string config;
  std::optional<std::string> store, name, dds, listen, unjoined, silent_goal, log_format;
  std::optional<unsigned> domain, index, metrics;
  std::optional<double> robot_silent_after_s, handling_s, silent_goal_after_s;
  bool asks_health = false;
};

void declare(CLI::App& app, Flags& flags) {
  app.set_version_flag("--version", "weft-server " WEFT_VERSION);
  app.footer(
      "Runs until SIGINT or SIGTERM; logs to standard error. Example: weft-server --store map\n"
      "Exit codes: 0 stopped by a signal, or healthy; 1 cannot work, or not healthy (one line says why); 2 wrong "
      "usage or settings");
  app.add_option("--config", flags.config, "TOML file with any of the settings below (store = \"DIR\", ...)");
  app.add_option("--store", flags.store, "Directory of the map; made if it is not there. Required here or in FILE");
  app.add_option("--dds", flags.dds, "fastdds | cyclonedds [fastdds]");
  app.add_option("--domain", flags.domain, "DDS domain, 0 to 200 [0]");
  app.add_option("--listen", flags.listen, "Address or name of the interface to bind to [127.0.0.1]");
  app.add_option("--index", flags.index, "Participant index, 0 to 100; fixes the ports that peers dial [0]");
  app.add_option("--name", flags.name, "What people call this server [server]");
  app.add_option("--handling-s", flags.handling_s,
                 "How long a robot that has come to its goal is not asked to make way, 0 to 3600 [10]");
  app.add_option("--robot-silent-after-s", flags.robot_silent_after_s,
                 "Seconds after which a robot counts as silent, over 0 to 3600 [5]");
  app.add_option("--silent-goal", flags.silent_goal,
                 "keep | hand_over | ask: what becomes of a goal for any robot whose robot is not heard [hand_over]");
  app.add_option("--silent-goal-after-s", flags.silent_goal_after_s,
                 "Seconds after which that is done, 1 to 86400 [60]");
  app.add_option("--unjoined", flags.unjoined,
                 "warn | one_drives: whether, of robots in parts of the map that nothing joins, one at a time is "
                 "released [warn]");
  app.add_option("--log-format", flags.log_format, "text | json: how each line of the log is written [text]");
  app.add_option("--metrics", flags.metrics,
                 "Port of 127.0.0.1 at which Prometheus is given metrics; 0: none is [0]");
  app.add_flag("--health", flags.asks_health,
               "Runs no server: says whether the one that works in --store DIR is healthy, and ends with 0 or 1");
}

template <class T>
std::string toml_value(const T& value) {
  std::ostringstream text;
  if constexpr (std::is_same_v<T, std::string>) {
    text << '"' << value << '"';
  } else {
    text << value;
  }
  return text.str();
}

template <class T>
void lay_over(std::string& text, const char* key, const std::optional<T>& flag) {
  if (flag) text += std::string(key) + " = " + toml_value(*flag) + "\n";
}

Options read(const config::Table& table) {
  Options options;
  options.store = table.text("store", "", 4096);
  options.name = table.text("name", "server", 64);
  const std::string vendor = table.choice("dds", "fastdds", {"fastdds", "cyclonedds"});
  options.vendor = vendor == "cyclonedds" ? bus::Vendor::cyclonedds : bus::Vendor::fastdds;
  options.domain = static_cast<unsigned>(table.integer("domain", 0, 0, 200));
  options.listen = table.text("listen", "127.0.0.1", 64);
  options.index = static_cast<unsigned>(table.integer("index", 0, 0, 100));
  options.handling_s = table.number("handling_s", 10.0, 0.0, 3600.0);
  options.robot_silent_after_s = table.number("robot_silent_after_s", 5.0, 0.001, 3600.0);
  options.silent_goal_after_s = table.number("silent_goal_after_s", 60.0, 1.0, 86400.0);
  const std::string silent = table.choice("silent_goal", "hand_over", {"keep", "hand_over", "ask"});
  options.silent_goal = silent == "keep"  ? SilentGoal::keep
                        : silent == "ask" ? SilentGoal::ask
                                          : SilentGoal::hand_over;
  ChargeLevels& charge = options.charge;
  charge.critical = 0.01 * table.number("charge_critical_percent", 10.0, 0.0, 100.0);
  charge.low = 0.01 * table.number("charge_low_percent", 25.0, 0.0, 100.0);
  charge.enough = 0.01 * table.number("charge_enough_percent", 60.0, 0.0, 100.0);
  charge.full = 0.01 * table.number("charge_full_percent", 95.0, 0.0, 100.0);
  charge.range_m = table.number("charge_range_m", charge.range_m, 1.0, 1e6);
  const std::string unjoined = table.choice("unjoined", "warn", {"warn", "one_drives"});
  options.unjoined = unjoined == "one_drives" ? Unjoined::one_drives : Unjoined::warn;
  const bool is_json = table.choice("log_format", "text", {"text", "json"}) == "json";
  options.log_format = is_json ? process::LogFormat::json : process::LogFormat::text;
  options.metrics = static_cast<std::uint16_t>(table.integer("metrics", 0, 0, 65'535));
  options.effective = table.effective();
  return options;
}

/// Puts the flags over the file, setting by setting.
void override_with(Options& options, const Options& given, const Flags& flags) {
  if (flags.store) options.store = given.store;
  if (flags.name) options.name = given.name;
  if (flags.dds) options.vendor = given.vendor;
  if (flags.domain) options.domain = given.domain;
  if (flags.listen) options.listen = given.listen;
  if (flags.index) options.index = given.index;
  if (flags.silent_goal) options.silent_goal = given.silent_goal;
  if (flags.silent_goal_after_s) options.silent_goal_after_s = given.silent_goal_after_s;
  if (flags.unjoined) options.unjoined = given.unjoined;
  if (flags.log_format) options.log_format = given.log_format;
  if (flags.metrics) options.metrics = given.metrics;
  if (flags.handling_s) options.handling_s = given.handling_s;
  if (flags.robot_silent_after_s) options.robot_silent_after_s = given.robot_silent_after_s;
  for (config::Setting& setting : options.effective) {
    for (const config::Setting& other : given.effective) {
      if (other.key == setting.key && !other.is_default) setting = other;
    }
  }
}

Leave wrong(const Error& error) {
  return {.exit_code = kWrong, .text = "weft-server: " + one_line(error.message) + "\n"};
}

}  // namespace

std::variant<Options, Leave> parse_options(int argc, const char* const* argv) {
  CLI::App app("The fleet map server: keeps the network of all robots and leads their goals.", "weft-server");
  Flags flags;
  declare(app, flags);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Leave{.exit_code = 0, .text = app.help()};
  } catch (const CLI::CallForVersion&) {
    return Leave{.exit_code = 0, .text = app.version() + "\n"};
  } catch (const CLI::ParseError& error) {
    return Leave{.exit_code = kWrong,
                 .text = "weft-server: " + one_line(error.what()) + "; weft-server --help lists the flags\n"};
  }
  const Result<std::string> file = process::read_settings(flags.config);
  if (!file) return wrong(file.error());
  const config::Table from_file = config::parse(*file, flags.config.empty() ? "configuration" : flags.config);
  Options options = read(from_file);
  if (const Result<void> good = from_file.result(); !good) return wrong(good.error());
  if (const Result<void> good = check(options.charge); !good) {
    return wrong({good.error().code, flags.config + ": " + good.error().message});
  }

  std::string text;
  lay_over(text, "store", flags.store);
  lay_over(text, "name", flags.name);
  lay_over(text, "dds", flags.dds);
  lay_over(text, "domain", flags.domain);
  lay_over(text, "listen", flags.listen);
  lay_over(text, "index", flags.index);
  lay_over(text, "handling_s", flags.handling_s);
  lay_over(text, "robot_silent_after_s", flags.robot_silent_after_s);
  lay_over(text, "silent_goal", flags.silent_goal);
  lay_over(text, "silent_goal_after_s", flags.silent_goal_after_s);
  lay_over(text, "unjoined", flags.unjoined);
  lay_over(text, "log_format", flags.log_format);
  lay_over(text, "metrics", flags.metrics);
  const config::Table from_flags = config::parse(text, "command line");
  const Options given = read(from_flags);
  if (const Result<void> good = from_flags.result(); !good) return wrong(good.error());
  override_with(options, given, flags);
  options.asks_health = flags.asks_health;
  if (options.store.empty()) {
    return wrong({ErrorCode::invalid, "no store is named: --store DIR (or store = \"DIR\" in the configuration)"});
  }
  return options;
}

}  // namespace weft::server
