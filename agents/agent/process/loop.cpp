#include "agents/agent/process/loop.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <thread>
#include <utility>

#include "agents/agent/diagnostic_watch.hpp"
#include "core/text.hpp"
#include "process/clocks.hpp"
#include "process/link/link_metrics.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;
using process::steady_now;
using process::wall_now;

constexpr int kMessagesATurn = 256;
constexpr Duration kLongestSleep = 200ms;  ///< signals are looked for in between
constexpr Duration kBehind = 500ms;        ///< later than this is not caught up with
constexpr Duration kAway = 1s;
constexpr Duration kNothingMore = 50ms;  ///< nothing more comes of what was sent meanwhile
constexpr Duration kLastWord = 50ms;     ///< it leaves the machine
constexpr Duration kCatchUpAtMost = 1s;
constexpr Duration kBetweenCounters = 30s;
constexpr Duration kFirstSilent = 5s;
constexpr Duration kSilent = 12s;  ///< a server greets every 5 s
constexpr Duration kBetweenSilences = 30s;

}  // namespace

Loop::Loop(const Parts& parts, double pace)
    : parts_(parts),
      pace_(pace),
      looked_(steady_now()),
      step_at_(looked_),
      counters_at_(step_at_ + kBetweenCounters),
      silent_at_(step_at_ + kFirstSilent),
      heard_at_(step_at_),
      published_at_(step_at_) {}

Result<void> Loop::until(const std::function<bool()>& stop) {
  Duration slept{};
  while (!stop()) {
    const bool was_away = note_absence(slept);
    take_messages();
    if (was_away) catch_up();
    if (const auto due = parts_.agent.next_tick(); due.has_value() && *due <= steady_now()) {
      const SteadyTime begun = steady_now();
      perform(parts_.agent.tick(begun));
      parts_.figures.ticked.add(steady_now() - begun);
    }
    if (!body_failure_ && steady_now() >= step_at_) step();
    log_counters();
    log_silence();
    show_life();
    SteadyTime next = steady_now() + kLongestSleep;
    if (!body_failure_) next = std::min(next, step_at_);
    if (parts_.vitals != nullptr) next = std::min(next, parts_.vitals->due());
    if (const auto due = parts_.agent.next_tick(); due.has_value()) next = std::min(next, *due);
    slept = std::max(next - steady_now(), Duration{});
    if (slept > Duration{}) parts_.link.wait(slept);
  }
  perform(parts_.agent.leave(steady_now()));
  std::this_thread::sleep_for(kLastWord);  // not on the inbox: what still comes is nobody's
  if (damage_) return tl::unexpected(*damage_);
  return {};
}

void Loop::take_messages() {
  for (int i = 0; i < kMessagesATurn; ++i) {
    const std::optional<msg::Message> message = parts_.link.take();
    if (!message.has_value()) break;
    heard_at_ = steady_now();
    silent_at_ = heard_at_ + kSilent;
    perform(parts_.agent.handle(*message, heard_at_, wall_now()));
    parts_.figures.handled.add(steady_now() - heard_at_);
  }
  for (const std::string& notice : parts_.link.bus().drain_notices()) parts_.log.warn(notice);
  for (const std::string& text : parts_.link.drain_refusal_texts()) parts_.log.warn("refused: " + text);
}

/// Takes what still comes of the time in which this process stood still (the bus's threads wake with it), before the
/// body moves again: an order may be among it.
void Loop::catch_up() {
  const SteadyTime end = steady_now() + kCatchUpAtMost;
  while (steady_now() < end && parts_.link.wait(kNothingMore)) take_messages();
  looked_ = steady_now();
}

/// Tells the agent when this thread was away from its inbox for a second longer than it meant to sleep. True if so.
bool Loop::note_absence(Duration meant) {
  const SteadyTime now = steady_now();
  const Duration away = now - looked_ - meant;
  looked_ = now;
  if (away <= kAway) return false;
  parts_.agent.was_away(away, now);
  parts_.figures.away_s += seconds(away);
  silent_at_ += away;
  parts_.log.warn("was away for " + fixed_number(seconds(away), 1) + " s", goal());
  return true;
}

void Loop::step() {
  Result<Sample> sample = parts_.body.step(command_);
  if (!sample) {
    body_failure_ = sample.error();
    if (sample.error().code == ErrorCode::corrupt) damage_ = sample.error();
    parts_.log.error("body: " + sample.error().message, goal());
    perform(parts_.agent.body_failed(sample.error(), steady_now()));
    return;
  }
  frame_ = sample->frame;
  schedule(sample->time);
  ++drive_.frames;
  const SteadyTime begun = steady_now();
  perform(parts_.agent.step(*sample, begun));
  drive_.stepped.add(steady_now() - begun);
}

void Loop::schedule(SensorTime sample) {
  const SteadyTime now = steady_now();
  step_at_ = now;
  if (pace_ <= 0.0) return;
  if (!anchor_.has_value()) anchor_ = Anchor{now, sample};
  step_at_ = anchor_->steady + from_seconds(seconds(sample - anchor_->sensor) / pace_);
  if (now - step_at_ > kBehind) {
    anchor_ = Anchor{now, sample};
    step_at_ = now;
  }
}

/// Writes records. A robot drives on without them, but whoever reads them hears of it.
void Loop::note(const AgentOutput& output) {
  parts_.records->note(output, frame_);
  parts_.records->note(parts_.agent.route(), frame_);
  if (damage_ || parts_.records->lost() == 0) return;
  damage_ = Error{ErrorCode::exhausted, "records could not be written; is the disk full?"};
  parts_.log.error(damage_->message, goal());
}

void Loop::perform(AgentOutput output) {
  command_ = output.command;
  const std::vector<process::LogField> about = goal_of_notes();
  for (const std::string& note : output.notes) parts_.log.info(note, about);
  if (parts_.records != nullptr) note(output);
  // The agent repeats messages that are not sent, as it does those that are lost on the way.
  for (const msg::Message& message : output.send) (void)parts_.link.send(message);
  if (output.exposes.has_value()) expose(*output.exposes);
  if (output.hand_stop) parts_.body.stop_hand();
  if (output.hand_start.has_value()) {
    perform(parts_.agent.hand_answered(parts_.body.drive_by_hand(*output.hand_start), steady_now()));
  }
}

void Loop::expose(const ExposureWish& wish) {
  const Result<void> exposed = parts_.body.expose(wish.sensor, wish.exposure);
  if (exposed || std::exchange(has_refused_exposure_, true)) return;
  parts_.log.info("exposure: " + exposed.error().message, goal());
}

void Loop::log_counters() {
  if (steady_now() < counters_at_) return;
  counters_at_ = steady_now() + kBetweenCounters;
  std::string line;
  for (const auto& [what, times] : parts_.agent.counters()) {
    std::uint64_t& told = counted_[what];
    if (times != told) line += (line.empty() ? "" : ", ") + what + " +" + std::to_string(times - told);
    told = times;
  }
  if (!line.empty()) parts_.log.info("counted: " + line);
  std::string measured = words_of(parts_.agent.diagnostics());
  if (measured != measured_) parts_.log.info("measured: " + measured);
  measured_ = std::move(measured);
}

void Loop::log_silence() {
  if (steady_now() < silent_at_) return;
  silent_at_ = steady_now() + kBetweenSilences;
  parts_.log.warn("no server is heard at " + parts_.server + ": is weft-server running there? Trying on", goal());
}

void Loop::show_life() {
  const SteadyTime now = steady_now();
  if (parts_.vitals == nullptr || parts_.vitals->due() > now) return;
  const std::string why = trouble();
  parts_.vitals->beat(now, why);
  publish_metrics(now, why);
}

/// Shows how the robot is to whoever watches it, at each sign of life. Being lost counts from one to the next.
void Loop::publish_metrics(SteadyTime now, const std::string& trouble) {
  if (parts_.metrics == nullptr) return;
  const AgentFigures figures = parts_.agent.figures(now);
  if (figures.state.mode == msg::RobotMode::lost) drive_.lost_s += seconds(now - published_at_);
  published_at_ = now;
  drive_.silent_server_s = seconds(now - heard_at_);
  drive_.has_body_failed = body_failure_.has_value();
  parts_.figures.is_well = trouble.empty();
  process::Metrics all = process::program_metrics(parts_.figures);
  for (process::Metrics& more : std::array{process::link_metrics(parts_.link), agent_metrics(figures, drive_)}) {
    std::ranges::move(more, std::back_inserter(all));
  }
  parts_.metrics->publish(std::move(all));
}

/// Returns why the robot does not do its work although this loop turns; empty: it does.
std::string Loop::trouble() const {
  if (!parts_.link.bus().is_open()) return "deaf: its link is not open, so it has no socket";
  if (body_failure_) return "the body failed: " + body_failure_->message;
  return damage_ ? damage_->message : parts_.agent.trouble();
}

/// Returns the goal that the robot has a route of, for the lines that belong to it; empty: none.
std::vector<process::LogField> Loop::goal() const {
  const std::optional<Route> route = parts_.agent.route();
  if (!route || !route->goal) return {};
  return {{"goal", to_string(route->goal)}};
}

/// Returns the goal for what the agent has just noted: of the route that it has now, or had until then.
std::vector<process::LogField> Loop::goal_of_notes() {
  std::vector<process::LogField> now = goal();
  std::vector<process::LogField> before = std::exchange(goal_before_, now);
  return now.empty() ? std::move(before) : std::move(now);
}

}  // namespace weft::agents
