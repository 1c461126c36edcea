#include "server/process/run.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <atomic>
#include <chrono>
#include <csignal>
#include <ctime>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "idl/bus/link.hpp"
#include "server/process/identity.hpp"
#include "server/process/signers.hpp"
#include "server/service.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr int kMessagesATurn = 256;
constexpr Duration kLongestSleep = 1s;
constexpr std::size_t kRefusalsLogged = 10;  ///< a turn
constexpr Duration kAway = 1s;
constexpr Duration kQuiet = 50ms;  ///< nothing more comes of what was sent meanwhile
constexpr Duration kCatchUpAtMost = 1s;

Now now() {
  return {.steady = SteadyTime(std::chrono::steady_clock::now().time_since_epoch()),
          .wall = WallTime(std::chrono::system_clock::now().time_since_epoch())};
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
  Loop(Service& service, bus::Link& link, spdlog::logger& log)
      : service_(service), link_(link), log_(log), looked_(now().steady) {}

  Result<void> until(const StopSignal& stop) {
    send(service_.tick(now()));
    while (!stop.asked()) {
      const std::optional<SteadyTime> next = service_.next_tick();
      const Duration sleep =
          next ? std::clamp<Duration>(*next - now().steady, Duration{}, kLongestSleep) : kLongestSleep;
      if (sleep > Duration{}) link_.wait(sleep);
      const bool was_away = note_absence(std::max(sleep, Duration{}));
      take_messages();
      if (was_away) catch_up();
      if (const auto due = service_.next_tick(); due && *due <= now().steady) {
        send(service_.tick(now()));
        note_absence({});
      }
      report_refusals();
      if (const std::optional<Error> broken = service_.broken()) return fail(*broken);
    }
    return {};
  }

 private:
  void take_messages() {
    for (int i = 0; i < kMessagesATurn; ++i) {
      const std::optional<msg::Message> message = link_.take();
      if (!message) break;
      send(service_.handle(*message, now()));
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
    log_.warn("was away for {:.1f} s: nobody is blamed for silence in that time", seconds(away));
    return true;
  }

  void send(const std::vector<msg::Message>& messages) {
    for (const msg::Message& message : messages) {
      if (const auto* const note = std::get_if<msg::EventNote>(&message)) {
        log_.info("{}: {} ({})", note->event.kind, note->event.cause, note->event.who);
      }
      // What is not sent is repeated by the service, like what is lost on the way.
      const Result<std::size_t> sent = link_.send(message);
      if (sent) {
        service_.sent(message, *sent);
      } else {
        service_.count("bus: not sent, " + std::string(to_string(sent.error().code)), 1);
        log_.debug("not sent: {}", sent.error().message);
      }
    }
  }

  void report_refusals() {
    for (const std::string& notice : link_.bus().drain_notices()) log_.warn("{}", notice);
    for (const auto& [what, times] : link_.refusals()) {
      std::uint64_t& told = told_[what];
      if (times > told) service_.count(what, times - told);
      told = times;
    }
    std::size_t logged = 0;
    for (const std::string& text : link_.drain_refusal_texts()) {
      if (++logged <= kRefusalsLogged) log_.warn("refused: {}", text);
    }
  }

  Service& service_;
  bus::Link& link_;
  spdlog::logger& log_;
  SteadyTime looked_;  ///< when the inbox was last looked at
  std::map<std::string, std::uint64_t> told_;
};

void log_settings(spdlog::logger& log, const Options& options) {
  std::istringstream lines(config::to_text(options.effective));
  for (std::string line; std::getline(lines, line);) log.info("setting {}", line);
}

}  // namespace

Result<void> run(const Options& options) {
  const sigset_t signals = hold_stop_signals();
  spdlog::logger log("weft-server", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  log.flush_on(spdlog::level::info);

  const Result<PeerId> self = load_identity(options.store);
  if (!self) return fail(self.error());
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
  const auto tell = [&log](const std::string& notice) { log.warn("{}", notice); };
  if (!bus::wait_until_open(
          link, [&stop] { return stop.asked(); }, tell))
    return {};

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
  log.info("ready: store {}, {} on {}, domain {}, index {}", options.store, config.vendor, options.listen,
           options.domain, options.index);
  const Result<void> served = Loop(**service, link, log).until(stop);
  if (served) log.info("stopped");
  return served;
}

}  // namespace weft::server
