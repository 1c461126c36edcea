#include "agents/agent/process/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "agents/agent/process/recorded_body.hpp"
#include "agents/agent/process/told_footprint.hpp"
#include "core/exit_code.hpp"
#include "core/names.hpp"
#include "core/protocol/messages.hpp"
#include "core/text.hpp"
#include "idl/bus/addresses.hpp"
#include "process/settings_file.hpp"

namespace weft::agents {
namespace {

enum class Kind { text, number, list };
/// Describes a setting that is a flag as well. The key is the flag with '_' for '-'.
struct Flag {
  const char* key = nullptr;
  Kind kind = Kind::text;
  const char* help = nullptr;
  bool is_simulated = false;  ///< is of the simulated body alone
};
constexpr std::array kFlags = {
    Flag{"name", Kind::text,
         "The robot's name: letters and digits of any script, '_', '.', '-', at most 64 bytes. Required"},
    Flag{"state", Kind::text, "Directory of the robot's identity and spool; made if it is not there. Required"},
    Flag{"method", Kind::text, "How it navigates; several, with commas between, each with a sensor of its own"},
    Flag{"body", Kind::text, "What is driven: "},
    Flag{"server", Kind::list, "The server's address, HOST or HOST:INDEX; repeatable [127.0.0.1]"},
    Flag{"dds", Kind::text, "fastdds | cyclonedds [fastdds]"},
    Flag{"domain", Kind::number, "DDS domain, 0 to 200 [0]"},
    Flag{"listen", Kind::text, "Address or name of the interface to bind to [127.0.0.1]"},
    Flag{"site", Kind::text, "sim: the site file; the robot starts where it says", true},
    Flag{"seed", Kind::number, "sim: of everything random [1]", true},
    Flag{"day", Kind::number, "sim: another calibration, light and noise each day [0]", true},
    Flag{"floors", Kind::text, "sim: folder of photographs to make the floor of", true},
    Flag{"hall", Kind::text, "sim: folder of photographs of what stands in the hall, for cameras that look ahead",
         true},
    Flag{"truth", Kind::text, "sim: file to which each frame's true pose is appended", true},
    Flag{"recording", Kind::text, "replay: folder in EuRoC layout"},
    Flag{"camera", Kind::text,
         "Which camera of a recording, or of a --calibration that has several: cam0; of a recording also several, "
         "cam0,cam1, or a stereo pair, cam0+cam1 [cam0]"},
    Flag{
        "calibration", Kind::text,
        "Camera file, as `weft calibrate` writes it, EuRoC's, Kalibr's or ROS's; replaces the body's. Where --camera "
        "names several cameras, a Kalibr chain of all of them"},
    Flag{"records", Kind::text, "Folder for fixes.jsonl, acks.jsonl and drives.jsonl"},
    Flag{"pace", Kind::number,
         "Seconds of the simulation or the recording a second at most; 0: as fast as it can [1]"},
    Flag{"log_format", Kind::text, "text | json: how each line of the log is written [text]"},
    Flag{"metrics", Kind::number, "Port of 127.0.0.1 at which Prometheus is given metrics; 0: none is [0]"},
};

std::string flag_of(const char* key) {
  std::string flag = std::string("--") + key;
  for (char& c : flag) c = c == '_' ? '-' : c;
  return flag;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text + at);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

std::string method_names() {
  std::string all;
  for (const std::string_view name : AllMethods::names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

/// Returns each method with what it looks through, for the help.
std::string methods_help() {
  std::string all;
  AllMethods::for_each([&]<class M>() {
    all += (all.empty() ? ": " : ", ") + std::string(M::name) + " (" + to_string(M::needs.kind) + " that looks " +
           to_string(M::needs.gaze) + ")";
  });
  return all + " [" + std::string(AllMethods::names.front()) + "]";
}

/// Returns the bodies that the program has, for the help.
std::string bodies_help(const Program& program) {
  std::string all;
  for (const BodyKind& body : program.bodies) all += (all.empty() ? "" : " | ") + std::string(body.name);
  return all + " [" + program.bodies.front().name + "]";
}

/// Returns a flag's values as a line of TOML, so that its bounds are stated once, for flag and file.
std::string as_toml(const Flag& flag, const std::vector<std::string>& values) {
  std::string line = std::string(flag.key) + " = ";
  switch (flag.kind) {
    case Kind::number:
      line += values.back();
      break;
    case Kind::text:
      line += quoted(values.back());
      break;
    case Kind::list: {
      line += "[";
      for (const std::string& value : values) line += quoted(value) + ", ";
      line += "]";
    }
  }
  return line + "\n";
}

/// Reads both sources at once: asks the file for every key, so that its own mistakes show; the command line wins.
class Sources {
  template <class Read>
  auto pick(const char* key, Read read) const {
    auto value = read(file_);
    return flags_.has(key) ? read(flags_) : value;
  }

 public:
  Sources(config::Table flags, config::Table file) : flags_(std::move(flags)), file_(std::move(file)) {}

  std::string text(const char* key, const std::string& fallback) const {
    return pick(key, [&](const config::Table& table) { return table.text(key, fallback, 4096); });
  }
  std::string choice(const char* key, const std::string& fallback, const std::vector<std::string>& allowed) const {
    return pick(key, [&](const config::Table& table) { return table.choice(key, fallback, allowed); });
  }
  double number(const char* key, double fallback, double low, double high) const {
    return pick(key, [&](const config::Table& table) { return table.number(key, fallback, low, high); });
  }
  template <class Integer>
  Integer integer(const char* key, std::int64_t fallback, std::int64_t low, std::int64_t high) const {
    return static_cast<Integer>(
        pick(key, [&](const config::Table& table) { return table.integer(key, fallback, low, high); }));
  }
  /// Reads where servers are: HOST or HOST:INDEX each.
  std::vector<std::string> servers() const {
    return pick("server", [](const config::Table& table) {
      bus::BusConfig config;
      config.role = msg::Role::agent;
      config.servers = table.texts("server", {{"127.0.0.1"}}, 1, 16);
      if (const Result<void> good = bus::check(config); !good) table.refuse("server", good.error().message);
      return config.servers;
    });
  }
  std::string name() const {
    return pick("name", [](const config::Table& table) {
      const std::string name = table.text("name", "", 4096);
      if (const Result<void> good = check_name("robot", name); !name.empty() && !good)
        table.refuse("name", good.error().message);
      return name;
    });
  }
  std::optional<std::string> maybe(const char* key) const {
    std::string value = text(key, "");
    return value.empty() ? std::nullopt : std::optional(std::move(value));
  }
  /// Reads the names of methods, with commas between, each once.
  std::vector<std::string> methods() const {
    return pick("method", [](const config::Table& table) {
      std::vector<std::string> methods =
          split(table.text("method", std::string(AllMethods::names.front()), 256), ',');
      std::set<std::string_view> once;
      for (const std::string& name : methods) {
        const bool is_known =
            std::find(AllMethods::names.begin(), AllMethods::names.end(), name) != AllMethods::names.end();
        if (!is_known) table.refuse("method", "there is no method \"" + name + "\"; there are " + method_names());
        if (!once.insert(name).second) table.refuse("method", "\"" + name + "\" is named twice");
      }
      return methods;
    });
  }
  /// Reads the kind of body. What is of a body that the program has not is refused.
  std::string body(const Program& program) const {
    std::string body = choice("body", program.bodies.front().name, {kSimulated, kRecordedBody.name});
    if (!has_body(program, body)) (flags_.has("body") ? flags_ : file_).refuse("body", without_body(body));
    if (has_body(program, kSimulated)) return body;
    for (const Flag& flag : kFlags) {
      for (const config::Table* const table : {&flags_, &file_}) {
        if (flag.is_simulated && table->has(flag.key)) table->refuse(flag.key, without_body(kSimulated));
      }
    }
    return body;
  }
  const config::Table& file() const { return file_; }

  std::vector<config::Setting> effective() const {
    std::vector<config::Setting> settings = file_.effective();
    for (const config::Setting& given : flags_.effective()) {
      for (config::Setting& setting : settings) {
        if (setting.key == given.key) setting = given;
      }
    }
    return settings;
  }

 private:
  config::Table flags_;
  config::Table file_;
};

Options read(const Program& program, const Sources& from) {
  constexpr std::int64_t kMost = INT64_MAX;
  Options options;
  options.name = from.name();
  options.state = from.text("state", "");
  options.methods = from.methods();
  options.body = from.body(program);
  options.servers = from.servers();
  const bool cyclone = from.choice("dds", "fastdds", {"fastdds", "cyclonedds"}) == "cyclonedds";
  options.vendor = cyclone ? bus::Vendor::cyclonedds : bus::Vendor::fastdds;
  options.domain = from.integer<unsigned>("domain", 0, 0, 200);
  options.listen = from.text("listen", "127.0.0.1");
  options.site = from.text("site", "");
  options.seed = from.integer<std::uint64_t>("seed", 1, 0, kMost);
  options.day = from.integer<std::uint64_t>("day", 0, 0, kMost);
  options.floors = from.maybe("floors");
  options.hall = from.maybe("hall");
  options.truth = from.maybe("truth");
  options.recording = from.text("recording", "");
  options.camera = from.text("camera", "cam0");
  options.calibration = from.maybe("calibration");
  const bool is_json = from.choice("log_format", "text", {"text", "json"}) == "json";
  options.log_format = is_json ? process::LogFormat::json : process::LogFormat::text;
  options.metrics = from.integer<std::uint16_t>("metrics", 0, 0, 65'535);
  options.records = from.maybe("records");
  options.pace = from.number("pace", 1.0, 0.0, 1000.0);
  options.footprint_radius_m = from.number("footprint_radius_m", 0.4, 0.01, kMostFootprint_m);
  options.window_hops = from.integer<std::uint32_t>("window_hops", 25, 1, 100'000);
  options.window_cap = from.integer<std::uint32_t>("window_cap", 2000, 1, 1'000'000);
  options.content_cache_mb = from.integer<std::uint64_t>("content_cache_mb", 256, 1, 65'536);
  options.bytes_per_second =
      from.integer<std::uint64_t>("bytes_per_second", 4LL << 20U, msg::kChunkBytes, 1LL << 34U);
  NavigationConfig navigation;
  navigation.follow.footprint_radius_m = options.footprint_radius_m;
  options.navigation = read_navigation_config(from.file().table("navigation"), navigation);
  AllMethods::for_each(
      [&]<class M>() { std::get<Configured<M>>(options.settings) = read_configured<M>(from.file(), navigation); });
  options.effective = from.effective();
  return options;
}

/// Returns what contradicts what in how it navigates, by all methods that it uses; empty when nothing does.
std::string contradiction(const Options& options) {
  std::vector<Error> wrong = check(options.navigation);
  AllMethods::for_each([&]<class M>() {
    if (std::ranges::find(options.methods, M::name) == options.methods.end()) return;
    const std::vector<Error> own = check(std::get<Configured<M>>(options.settings).navigation);
    wrong.insert(wrong.end(), own.begin(), own.end());
  });
  if (!wrong.empty()) return wrong.front().message;
  const double told_m = told_footprint_m(options);
  if (told_m <= kMostFootprint_m) return {};
  return "footprint_radius_m " + short_number(options.footprint_radius_m) + " and aside_m are " +
         short_number(told_m) + " m together, at most " + short_number(kMostFootprint_m);
}

/// Returns what is missing for the body that was chosen; empty when nothing is.
std::string missing(const Options& options) {
  if (options.asks_health && !options.state.empty()) return {};
  if (options.name.empty() && !options.asks_health) return "--name NAME is missing: what people call this robot";
  if (options.state.empty()) return "--state DIR is missing: where its identity and spool are kept";
  if (options.body == kSimulated && options.site.empty()) return "--body sim needs --site FILE";
  if (options.body == kRecordedBody.name && options.recording.empty()) return "--body replay needs --recording DIR";
  return {};
}

Leave wrong(const Program& program, const std::string& message) {
  return {.exit_code = kWrong, .text = std::string(program.name) + ": " + one_line(message) + "\n"};
}

/// Returns an example of a command line, for the help.
std::string example_of(const Program& program) {
  const bool simulates = has_body(program, kSimulated);
  return "Example, a " + std::string(simulates ? "simulated robot" : "recording") + ":\n  " + program.name +
         " --name r1 --state state/r1 " +
         (simulates ? "--site deploy/sites/demo.toml\n"
                    : "--recording drive --pace 0\nSimulated robots have a program of their own, weft-agent-sim.\n");
}

}  // namespace

std::variant<Options, Leave> parse_options(const Program& program, int argc, const char* const* argv) {
  CLI::App app("The agent of one robot: sees, localises, drives, and shares what it learns with weft-server.",
               program.name);
  app.set_version_flag("--version", std::string(program.name) + " " + WEFT_VERSION);
  app.footer(
      "Runs until SIGINT or SIGTERM; logs to standard error. " + example_of(program) +
      "`weft-agent calibrate --help`: camera and mount are found out, nothing is driven.\n"
      "Exit codes: 0 stopped by a signal, or healthy; 1 cannot work, or not healthy (one line says why); 2 wrong "
      "usage or settings");
  std::string file;
  app.add_option("--config", file, "TOML file with any of the settings below, and more (docs/operating.md)");
  std::map<std::string, std::vector<std::string>> given;
  for (const Flag& flag : kFlags) {
    const std::string_view key = flag.key;
    const std::string help = flag.help + (key == "method" ? methods_help()
                                          : key == "body" ? bodies_help(program)
                                                          : std::string());
    CLI::Option* const option = app.add_option(flag_of(flag.key), given[flag.key], help);
    option->expected(1)->take_last();
    if (flag.is_simulated && !has_body(program, kSimulated)) option->group("");  // is not shown
    if (flag.kind == Kind::list) option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->expected(1, 16);
    if (flag.kind == Kind::number) option->check(CLI::Number);
  }
  bool asks_health = false;
  app.add_flag("--health", asks_health,
               "Runs no agent: says whether the one that works in --state DIR is healthy, and ends with 0 or 1");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Leave{.exit_code = 0, .text = app.help()};
  } catch (const CLI::CallForVersion&) {
    return Leave{.exit_code = 0, .text = app.version() + "\n"};
  } catch (const CLI::ParseError& error) {
    return wrong(program, std::string(error.what()) + "; " + program.name + " --help lists the flags");
  }
  const Result<std::string> from_file = process::read_settings(file);
  if (!from_file) return wrong(program, from_file.error().message);
  std::string from_flags;
  for (const Flag& flag : kFlags) {
    if (!given[flag.key].empty()) from_flags += as_toml(flag, given[flag.key]);
  }
  const config::Table flags = config::parse(from_flags, "command line");
  const config::Table table = config::parse(*from_file, file.empty() ? "configuration" : file);
  Options options = read(program, Sources(flags, table));
  options.asks_health = asks_health;
  if (const Result<void> good = table.result(); !good) return wrong(program, good.error().message);
  if (const Result<void> good = flags.result(); !good) return wrong(program, good.error().message);
  if (const std::string what = contradiction(options); !what.empty()) return wrong(program, file + ": " + what);
  if (const std::string what = missing(options); !what.empty()) return wrong(program, what);
  return options;
}

}  // namespace weft::agents
