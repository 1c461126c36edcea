#include "server/process/run.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "core/text.hpp"
#include "idl/bus/link.hpp"
#include "process/clocks.hpp"
#include "process/link/link_metrics.hpp"
#include "process/log.hpp"
#include "process/metrics/metrics_server.hpp"
#include "process/metrics/program_metrics.hpp"
#include "process/vitals.hpp"
#include "server/metrics/server_metrics.hpp"
#include "server/process/identity.hpp"
#include "server/process/signers.hpp"
#include "server/service.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr int kMessagesATurn = 256;
constexpr std::size_t kRefusalsLogged = 10;  ///< a turn
constexpr Duration kAway = 1s;
constexpr Duration kQuiet = 50ms;  ///< nothing more comes of what was sent meanwhile
constexpr Duration kCatchUpAtMost = 1s;

Now now() {
  return {.steady = process::steady_now(), .wall = process::wall_now()};
}

/// Keeps SIGINT and SIGTERM from this thread and all that are started after it.
sigset_t hold_stop_signals() {
  sigset_t signals{};
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// Waits for one of the held signals in a thread of its own, and wakes the bus once when it has come. Ends before
/// the bus does.
class StopSignal {
 public:
  StopSignal(const sigset_t& signals, bus::Bus& bus)
      : watcher_([this, signals, &bus](const std::stop_token& stop) {
          const timespec moment = {.tv_sec = 0, .tv_nsec = 200'000'000};
          while (!stop.stop_requested()) {
            if (sigtimedwait(&signals, nullptr, &moment) < 0) continue;
            asked_ = true;
            bus.wake();
            return;
          }
        }) {}
  bool asked() const { return asked_; }

 private:
  std::atomic<bool> asked_ = false;  // shared
  std::jthread watcher_;             // last member: stops first
};

/// Carries messages between the bus and the service, in this thread.
class Loop {
 public:
  struct Parts {
    Service& service;
    bus::Link& link;
    process::Log& log;
    process::Vitals& vitals;
    process::MetricsServer* metrics = nullptr;  ///< null: none are served
    process::ProgramFigures figures;            ///< with what its metrics begin
  };
  explicit Loop(const Parts& parts)
      : service_(parts.service),
        link_(parts.link),
        log_(parts.log),
        vitals_(parts.vitals),
        metrics_(parts.metrics),
        figures_(parts.figures),
        looked_(now().steady) {}

  Result<void> until(const StopSignal& stop) {
    tick();
    while (!stop.asked()) {
      const SteadyTime next = std::min(vitals_.due(), service_.next_tick().value_or(SteadyTime::max()));
      const Duration sleep = std::max(next - now().steady, Duration{});
      if (sleep > Duration{}) link_.wait(sleep);
      const bool was_away = note_absence(sleep);
      take_messages();
      if (was_away) catch_up();
      if (const auto due = service_.next_tick(); due && *due <= now().steady) {
        tick();
        note_absence({});
      }
      report_refusals();
      if (vitals_.due() <= now().steady) show_life();
      if (const std::optional<Error> broken = service_.broken()) return fail(*broken);
    }
    return {};
  }

 private:
  void tick() {
    const Now begun = now();
    send(service_.tick(begun));
    figures_.ticked.add(now().steady - begun.steady);
  }

  void take_messages() {
    for (int i = 0; i < kMessagesATurn; ++i) {
      const std::optional<msg::Message> message = link_.take();
      if (!message) break;
      const Now begun = now();
      send(service_.handle(*message, begun));
      figures_.handled.add(now().steady - begun.steady);
      note_absence({});
    }
  }

  /// Takes what still comes of the time in which this process stood still: the bus's threads wake with it.
  void catch_up() {
    const SteadyTime end = now().steady + kCatchUpAtMost;
    while (now().steady < end && link_.wait(kQuiet)) take_messages();
    looked_ = now().steady;
  }

  /// Tells the service when this thread was away from its inbox for a second longer than it meant to sleep: it was
  /// busy, or the process stood still. True if so.
  bool note_absence(Duration meant) {
    const Now at = now();
    const Duration away = at.steady - looked_ - meant;
    looked_ = at.steady;
    if (away <= kAway) return false;
    service_.was_away(away, at);
    figures_.away_s += seconds(away);
    log_.warn("was away for " + fixed_number(seconds(away), 1) + " s: nobody is blamed for silence in that time");
    return true;
  }

  void send(const std::vector<msg::Message>& messages) {
    for (const msg::Message& message : messages) {
      if (const auto* const note = std::get_if<msg::EventNote>(&message)) {
        log_event(note->event);
      }
      // What is not sent is repeated by the service, like what is lost on the way.
      const Result<std::size_t> sent = link_.send(message);
      if (sent) {
        service_.sent(message, *sent);
      } else {
        service_.count("bus: not sent, " + std::string(to_string(sent.error().code)), 1);
      }
    }
  }

  /// Writes an event to the log, with the goal that it names, or that its robot is to reach.
  void log_event(const msg::Event& event) {
    const GoalId goal = event.goal || !event.robot ? event.goal : service_.goal_of(event.robot);
    log_.event(event.kind, event.cause,
               {{"who", event.who},
                {"robot", event.robot ? to_string(event.robot) : ""},
                {"goal", goal ? to_string(goal) : ""}});
  }

  /// Returns why the server does not do its work although this loop turns; empty: it does.
  std::string trouble() const {
    if (!link_.bus().is_open()) return "deaf: its link is not open, so it has no socket";
    const std::optional<Error> refusal = service_.store_refuses();
    return refusal ? "the store refused the last write: " + refusal->message : std::string();
  }

  /// Shows health probes that this loop turns, and metrics to whoever watches the server.
  void show_life() {
    const Now at = now();
    const std::string why = trouble();
    vitals_.beat(at.steady, why);
    if (metrics_ == nullptr) return;
    figures_.is_well = why.empty();
    process::Metrics all = process::program_metrics(figures_);
    for (process::Metrics& more : std::array{process::link_metrics(link_), server_metrics(service_.figures(at))}) {
      std::ranges::move(more, std::back_inserter(all));
    }
    metrics_->publish(std::move(all));
  }

  void report_refusals() {
    for (const std::string& notice : link_.bus().drain_notices()) log_.warn(notice);
    for (const auto& [what, times] : link_.refusals()) {
      std::uint64_t& told = told_[what];
      if (times > told) service_.count(what, times - told);
      told = times;
    }
    std::size_t logged = 0;
    for (const std::string& text : link_.drain_refusal_texts()) {
      if (++logged <= kRefusalsLogged) log_.warn("refused: " + text);
    }
  }

  Service& service_;
  bus::Link& link_;
  process::Log& log_;
  process::Vitals& vitals_;
  process::MetricsServer* metrics_;
  process::ProgramFigures figures_;
  SteadyTime looked_;  ///< when the inbox was last looked at
  std::map<std::string, std::uint64_t> told_;
};

void log_settings(process::Log& log, const Options& options) {
  std::istringstream lines(config::to_text(options.effective));
  for (std::string line; std::getline(lines, line);) log.info("setting " + line);
}

}  // namespace

Result<void> run(const Options& options) {
  const sigset_t signals = hold_stop_signals();
  process::Log log = process::Log::to_standard_error("weft-server", options.log_format);
  const auto tell = [&log](const std::string& notice) { log.warn(notice); };

  const Result<PeerId> self = load_identity(options.store);
  if (!self) return fail(self.error());
  std::optional<process::MetricsServer> metrics;
  if (options.metrics != 0) {
    Result<process::MetricsServer> served = process::MetricsServer::open(options.metrics);
    if (!served) return fail(served.error());
    metrics.emplace(*std::move(served));
  }
  process::Vitals vitals("weft-server", options.store, tell, process::ServiceManager::of_environment(), now().steady);
  vitals.starting("it opens its store", now().steady);
  Result<std::unique_ptr<storage::MapStore>> store = storage::open_sqlite(options.store, {.empties_log_aside = true});
  if (!store) return fail(store.error());
  Result<std::unique_ptr<bus::Bus>> opened = bus::open(options.vendor, {.role = msg::Role::server,
                                                                        .self = *self,
                                                                        .domain = options.domain,
                                                                        .listen = options.listen,
                                                                        .servers = {},
                                                                        .server_index = options.index});
  if (!opened) return fail(opened.error());
  bus::Link link(*std::move(opened));
  const StopSignal stop(signals, link.bus());
  const auto stopped_waiting = [&stop, &vitals] {
    if (const SteadyTime at = now().steady; vitals.due() <= at) vitals.starting("it waits for its link", at);
    return stop.asked();
  };
  if (!bus::wait_until_open(link, stopped_waiting, tell)) return {};
  vitals.starting("it loads its map", now().steady);

  Random random = random_from_machine();
  ServiceConfig config;
  config.self = *self;
  config.incarnation = random.next() | 1U;
  config.name = options.name;
  config.software = WEFT_VERSION;
  config.vendor = link.bus().vendor();
  config.handling_s = options.handling_s;
  config.robot_silent_after_s = options.robot_silent_after_s;
  config.silent_goal = options.silent_goal;
  config.silent_goal_after_s = options.silent_goal_after_s;
  config.unjoined = options.unjoined;
  config.charge = options.charge;
  config.signers = all_signers();
  Result<std::unique_ptr<Service>> service = start(config, **store, random, now());
  if (!service) return fail(service.error());

  log_settings(log, options);
  log.info("ready: store " + options.store + ", " + config.vendor + " on " + options.listen + ", domain " +
           std::to_string(options.domain) + ", index " + std::to_string(options.index));
  vitals.ready(now().steady);
  const Result<void> served =
      Loop({.service = **service,
            .link = link,
            .log = log,
            .vitals = vitals,
            .metrics = metrics ? &*metrics : nullptr,
            .figures = {.program = "weft-server", .version = WEFT_VERSION, .vendor = config.vendor}})
          .until(stop);
  vitals.stopping();
  if (served) log.info("stopped");
  return served;
}

}  // namespace weft::server
