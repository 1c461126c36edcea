#include "tests/containers/light/robot.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include "agents/agent/process/identity.hpp"
#include "agents/agent/process/loop.hpp"
#include "agents/agent/process/records.hpp"
#include "agents/navigation/navigator_of.hpp"
#include "process/clocks.hpp"
#include "process/log.hpp"
#include "process/vitals.hpp"
#include "storage/spool/file_spool.hpp"
#include "tests/containers/light/open_link.hpp"
#include "tests/containers/light/true_body.hpp"
#include "tests/support/marks.hpp"

namespace weft::light {
namespace {

constexpr const char* kProgram = "weft-light-agents";

Result<std::unique_ptr<TrueBody>> make_body(const Options& options,
                                            const std::shared_ptr<const simulation::Site>& site, std::size_t number) {
  const std::string truth = options.records + "/truth-" + name_of(number) + ".jsonl";
  const double start_m = site->course().start_m(number - 1, options.fleet);
  const Result<Standing> stands = last_standing(truth, {0, site->pose(start_m, {})});
  if (!stands) return fail(stands.error());
  Random random = Random(options.seed).fork(100 + number).fork(stands->frame);
  auto body = std::make_unique<simulation::MarksBody>(site, stands->site_from_robot, random);
  return TrueBody::make(std::move(body), truth, name_of(number), stands->frame);
}

agents::AgentConfig config_of(const Options& options, std::size_t number, const RobotId& self,
                              const std::string& body) {
  agents::AgentConfig config;
  config.self = self;
  config.incarnation = agents::random_from_machine().next() | 1U;
  config.name = name_of(number);
  config.software = WEFT_VERSION;
  config.vendor = options.vendor == bus::Vendor::fastdds ? "fastdds" : "cyclonedds";
  config.body = body;
  config.can_be_taught_along = true;
  return config;
}

}  // namespace

std::shared_ptr<const simulation::Site> site_of(const Options& options) {
  return std::make_shared<const simulation::Site>(simulation::make_site(options.site, Random(options.seed).fork(1)));
}

Result<void> run_robot(const Options& options, const std::shared_ptr<const simulation::Site>& site,
                       std::size_t number, const std::function<bool()>& stop) {
  const std::string name = name_of(number);
  const std::string directory = options.state + "/" + name;
  process::Log log = process::Log::to_standard_error(kProgram, process::LogFormat::text);
  log.always_about({{"robot", name}});
  const auto warn = [&log, &name](const std::string& text) { log.warn(name + ": " + text); };
  const Result<agents::StateDirectory> state = agents::StateDirectory::open(directory);
  if (!state) return fail(state.error());
  const Result<RobotId> self = state->identity();
  if (!self) return fail(self.error());
  process::Vitals vitals(kProgram, directory, warn, process::ServiceManager::of_environment(), process::steady_now());
  const Result<std::unique_ptr<storage::Spool>> spool = storage::open_file_spool(state->spool());
  if (!spool) return fail(spool.error());
  for (const std::string& skipped : (*spool)->skipped()) warn("spool: " + skipped);
  Result<agents::Records> records = agents::Records::open(options.records, name);
  if (!records) return fail(records.error());
  const Result<std::unique_ptr<TrueBody>> body = make_body(options, site, number);
  if (!body) return fail(body.error());
  const auto stopped_waiting = [&] {
    if (const SteadyTime at = process::steady_now(); vitals.due() <= at) vitals.starting("it waits for its link", at);
    return stop();
  };
  Result<std::optional<bus::Link>> link = open_link(options, *self, stopped_waiting, warn);
  if (!link) return fail(link.error());
  if (!link->has_value()) return {};

  const agents::AgentConfig config = config_of(options, number, *self, (*body)->kind());
  auto navigator = agents::make_navigator(agents::MarksMethod(), agents::NavigationConfig());
  const Result<std::unique_ptr<agents::Agent>> agent =
      agents::start(config, std::move(navigator), **spool, agents::random_from_machine(), process::steady_now());
  if (!agent) return fail(agent.error());
  log.info("ready: " + name + " " + to_string(*self));
  vitals.ready(process::steady_now());
  agents::Loop loop({.agent = **agent,
                     .body = **body,
                     .link = **link,
                     .records = &*records,
                     .log = log,
                     .server = options.servers.front(),
                     .vitals = &vitals},
                    options.pace);
  const Result<void> ended = loop.until(stop);
  vitals.stopping();
  return ended;
}

}  // namespace weft::light
