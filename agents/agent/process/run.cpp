#include "agents/agent/process/run.hpp"

#include <csignal>
#include <ctime>
#include <memory>
#include <sstream>
#include <utility>

#include "agents/agent/process/equip.hpp"
#include "agents/agent/process/identity.hpp"
#include "agents/agent/process/loop.hpp"
#include "agents/agent/process/records.hpp"
#include "agents/agent/process/told_footprint.hpp"
#include "core/exit_code.hpp"
#include "core/text.hpp"
#include "process/clocks.hpp"
#include "process/log.hpp"
#include "process/metrics/metrics_server.hpp"
#include "process/vitals.hpp"
#include "storage/spool/file_spool.hpp"

namespace weft::agents {
namespace {

/// Blocks SIGINT and SIGTERM in every thread from here on; they are asked for in between. Construct it first.
class StopSignal {
 public:
  StopSignal() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  bool came() const {
    const timespec none{};
    return sigtimedwait(&signals_, nullptr, &none) > 0;
  }

 private:
  sigset_t signals_{};
};

void log_settings(process::Log& log, const Options& options) {
  const double told_m = told_footprint_m(options);
  if (told_m > options.footprint_radius_m) {
    log.info("footprint told to the server: " + short_number(told_m) +
             " m, as its method may leave its route by aside_m");
  }
  std::istringstream lines(config::to_text(options.effective));
  for (std::string line; std::getline(lines, line);) log.info("setting " + line);
}

std::string addresses(const Options& options) {
  std::string words;
  for (const std::string& server : options.servers) words += (words.empty() ? "" : ", ") + server;
  return words + ", domain " + std::to_string(options.domain);
}

AgentConfig config_of(const Options& options, const RobotId& self, const Body& body,
                      const std::vector<Equipped>& equipped, const std::string& vendor) {
  AgentConfig config;
  config.self = self;
  config.incarnation = random_from_machine().next() | 1U;
  config.name = options.name;
  config.software = WEFT_VERSION;
  config.vendor = vendor;
  config.body = body.kind();
  config.can_be_taught_along = config.body == kSimulated;
  for (const Equipped& one : equipped) {
    const bool has_file = config.cameras.empty() && options.calibration.has_value();
    config.cameras.push_back({.id = one.rig.camera().id,
                              .width = static_cast<std::uint32_t>(one.rig.camera().width),
                              .height = static_cast<std::uint32_t>(one.rig.camera().height),
                              .calibration = has_file ? *options.calibration : one.rig.camera().id});
  }
  config.footprint_radius_m = told_footprint_m(options);
  config.window_hops = options.window_hops;
  config.window_cap = options.window_cap;
  config.content_cache_bytes = options.content_cache_mb << 20U;
  config.bytes_per_second = options.bytes_per_second;
  return config;
}

Result<std::unique_ptr<bus::Bus>> open_bus(const Options& options, const RobotId& self) {
  bus::BusConfig config;
  config.role = msg::Role::agent;
  config.self = self;
  config.domain = options.domain;
  config.listen = options.listen;
  config.servers = options.servers;
  return bus::open(options.vendor, config);
}

/// Returns how its work ended. It has begun, so that no error is one of its settings any more.
Result<void> after_work(const Result<void>& ended) {
  if (ended || exit_code_of(ended.error().code) == kFailed) return ended;
  return fail(ErrorCode::internal, ended.error().message);
}

}  // namespace

Result<void> run(const Program& program, const Options& options) {
  const StopSignal stop;
  process::Log log = process::Log::to_standard_error(program.name, options.log_format);
  log.always_about({{"robot", options.name}});
  const auto warn = [&log](const std::string& text) { log.warn(text); };
  Result<StateDirectory> state = StateDirectory::open(options.state);
  if (!state) return fail(state.error());
  const Result<RobotId> self = state->identity();
  if (!self) return fail(self.error());
  std::optional<process::MetricsServer> metrics;
  if (options.metrics != 0) {
    Result<process::MetricsServer> served = process::MetricsServer::open(options.metrics);
    if (!served) return fail(served.error());
    metrics.emplace(std::move(*served));
  }
  process::Vitals vitals(program.name, options.state, warn, process::ServiceManager::of_environment(),
                         process::steady_now());
  vitals.starting("it reads its spool and prepares its body", process::steady_now());
  Result<std::unique_ptr<storage::Spool>> spool = storage::open_file_spool(state->spool());
  if (!spool) return fail(spool.error());
  for (const std::string& skipped : (*spool)->skipped()) log.warn("spool: " + skipped);
  std::optional<Records> records;
  if (options.records.has_value()) {
    Result<Records> opened = Records::open(*options.records, options.name);
    if (!opened) return fail(opened.error());
    records.emplace(std::move(*opened));
  }
  Result<std::unique_ptr<Body>> body = make_body(program, options, warn);
  if (!body) return fail(body.error());
  const Result<std::vector<Equipped>> equipped = equip(options, **body, warn);
  if (!equipped) return fail(equipped.error());
  Result<std::unique_ptr<Navigator>> navigator = make_navigator(options, *equipped, (*body)->rig());
  if (!navigator) return fail(navigator.error());
  Result<std::unique_ptr<bus::Bus>> opened = open_bus(options, *self);
  if (!opened) return fail(opened.error());
  bus::Link link(std::move(*opened));
  const auto stopped_waiting = [&stop, &vitals] {
    if (const SteadyTime at = process::steady_now(); vitals.due() <= at) vitals.starting("it waits for its link", at);
    return stop.came();
  };
  if (!bus::wait_until_open(link, stopped_waiting, warn)) return {};

  const AgentConfig config = config_of(options, *self, **body, *equipped, link.bus().vendor());
  Result<std::unique_ptr<Agent>> agent =
      start(config, std::move(*navigator), **spool, random_from_machine(), process::steady_now());
  if (!agent) return fail(agent.error());
  log_settings(log, options);  // not before everything is there: what goes wrong until then is one line
  std::string methods;
  for (const std::string& method : options.methods) methods += (methods.empty() ? "" : ",") + method;
  log.info("ready: " + options.name + " " + to_string(*self) + ", " + config.vendor + ", body " + config.body +
           ", method " + methods);
  vitals.ready(process::steady_now());
  Loop loop({.agent = **agent,
             .body = **body,
             .link = link,
             .records = records.has_value() ? &*records : nullptr,
             .log = log,
             .server = addresses(options),
             .vitals = &vitals,
             .metrics = metrics ? &*metrics : nullptr,
             .figures = {.program = program.name, .version = WEFT_VERSION, .vendor = config.vendor}},
            options.pace);
  const Result<void> ended = loop.until([&stop] { return stop.came(); });
  vitals.stopping();
  log.info("stopped");
  return after_work(ended);
}

}  // namespace weft::agents
