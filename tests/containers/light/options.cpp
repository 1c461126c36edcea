#include "tests/containers/light/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/text.hpp"
#include "tests/simulation/site.hpp"

namespace weft::light {
namespace {

constexpr int kUsage = 2;
constexpr std::size_t kMostRobots = 200;

Leave wrong(const std::string& what) {
  return {kUsage, "weft-light-agents: " + what + "; weft-light-agents --help lists the flags\n"};
}

void declare(CLI::App& app, Options& options, std::string& vendor) {
  app.set_version_flag("--version", "weft-light-agents " WEFT_VERSION);
  app.add_option("--first", options.first, "Number of its first robot, 1 to 200 [1]")
      ->check(CLI::Range(std::size_t{1}, kMostRobots));
  app.add_option("--robots", options.robots, "How many robots this process has, 1 to 200 [1]")
      ->check(CLI::Range(std::size_t{1}, kMostRobots));
  app.add_option("--fleet", options.fleet, "How many robots all processes have, 1 to 200 [1]")
      ->check(CLI::Range(std::size_t{1}, kMostRobots));
  app.add_option("--pace", options.pace, "Body seconds a second, 0.1 to 50 [1]")->check(CLI::Range(0.1, 50.0));
  app.add_option("--site", options.site, "ring | aisles [ring]")->check(CLI::IsMember(simulation::site_names()));
  app.add_option("--seed", options.seed, "Of the site and of the robots' noise [101]");
  app.add_option("--state", options.state, "Directory; each robot has one of its own in it");
  app.add_option("--records", options.records,
                 "Directory of truth.jsonl and what agents record; a robot goes on where it was");
  app.add_option("--lines", options.lines, "Writes the robots' teach lines into this directory, and ends");
  app.add_option("--dds", vendor, "fastdds | cyclonedds [fastdds]");
  app.add_option("--protocol", options.protocol,
                 "Does nothing but greet as the agent --first of a version that speaks this protocol alone, 1 to 100")
      ->check(CLI::Range(1U, 100U));
  app.add_option("--domain", options.domain, "DDS domain, 0 to 200 [0]")->check(CLI::Range(0U, 200U));
  app.add_option("--listen", options.listen, "Address or name of the interface to bind to [127.0.0.1]");
  app.add_option("--server", options.servers, "HOST or HOST:INDEX of the server [127.0.0.1]");
}

}  // namespace

std::variant<Options, Leave> parse_options(int argc, const char* const* argv) {
  CLI::App app("Agents of simulated robots that see numbered marks: no images, so many fit a machine. For tests.",
               "weft-light-agents");
  Options options;
  std::string vendor = "fastdds";
  declare(app, options, vendor);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Leave{.exit_code = 0, .text = app.help()};
  } catch (const CLI::CallForVersion&) {
    return Leave{.exit_code = 0, .text = app.version() + "\n"};
  } catch (const CLI::ParseError& error) {
    return wrong(one_line(error.what()));
  }
  const Result<bus::Vendor> parsed = bus::parse_vendor(vendor);
  if (!parsed) return wrong("--dds: " + parsed.error().message);
  options.vendor = *parsed;
  if (options.first + options.robots - 1 > options.fleet) {
    return wrong("--fleet " + std::to_string(options.fleet) + " has no robot " +
                 std::to_string(options.first + options.robots - 1));
  }
  if (options.lines.empty() && (options.state.empty() || options.records.empty()))
    return wrong("give --state and --records, or --lines");
  return options;
}

}  // namespace weft::light
