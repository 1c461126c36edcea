#include "agents/agent/robot_agent.hpp"

#include <algorithm>
#include <utility>

#include "core/names.hpp"
#include "core/network/change.hpp"

namespace weft::agents {
namespace {

/// What leaves at once when the budget has been resting.
std::uint64_t burst(std::uint64_t bytes_per_second) {
  return std::max<std::uint64_t>(msg::kChunkBytes, bytes_per_second / 8);
}

msg::Hello hello(const AgentConfig& config) {
  msg::Hello own;
  own.peer = config.self;
  own.incarnation = config.incarnation;
  own.role = msg::Role::agent;
  own.name = config.name;
  own.software = config.software;
  own.vendor = config.vendor;
  return own;
}

WindowDefinition everything(const AgentConfig& config) {
  return {.centre = std::nullopt, .hops = config.window_hops, .cap = config.window_cap, .route = {}};
}

Result<void> check_bounds(const AgentConfig& config) {
  if (Result<void> named = check_name("robot", config.name); !named) return named;
  if (!config.self) return fail(ErrorCode::invalid, "identity: is all zero; remove it and start again");
  if (!(config.footprint_radius_m > 0.0 && config.footprint_radius_m <= 5.0)) {
    return fail(ErrorCode::invalid,
                "footprint_radius_m " + std::to_string(config.footprint_radius_m) + ": must be in (0, 5]");
  }
  if (config.window_cap < 1 || config.window_cap > 1'000'000) {
    return fail(ErrorCode::invalid, "window_cap " + std::to_string(config.window_cap) + ": must be in [1, 1000000]");
  }
  if (config.bytes_per_second < msg::kChunkBytes) {
    return fail(ErrorCode::invalid, "bytes_per_second " + std::to_string(config.bytes_per_second) +
                                        ": must be at least one chunk, " + std::to_string(msg::kChunkBytes));
  }
  return {};
}

void add_to(Counters& all, const Counters& more) {
  for (const auto& [name, count] : more) all[name] += count;
}

}  // namespace

Result<std::unique_ptr<Agent>> start(const AgentConfig& config, std::unique_ptr<Navigator> navigator,
                                     storage::Spool& spool, Random random, SteadyTime now) {
  if (Result<void> bounds = check_bounds(config); !bounds) return fail(bounds.error());
  Result<Spooler> spooler = Spooler::open(spool, SpoolerConfig{}, config.self, now);
  if (!spooler) return fail(spooler.error());
  return std::make_unique<RobotAgent>(config, std::move(navigator), std::move(*spooler), random, now);
}

RobotAgent::RobotAgent(const AgentConfig& config, std::unique_ptr<Navigator> navigator, Spooler spooler,
                       Random random, SteadyTime now)
    : config_(config),
      navigator_(std::move(navigator)),
      random_(random),
      session_(hello(config), random_.fork(1), now),
      spooler_(std::move(spooler)),
      replica_(everything(config), (random_.next() >> 1U) | 1U, now),
      recogniser_(random_.next() >> 1U),
      cache_(config.content_cache_bytes, config.bytes_per_second),
      budget_(config.bytes_per_second, burst(config.bytes_per_second), now),
      search_at_(now),
      describe_at_(now),
      state_at_(now),
      state_sent_at_(now) {}

AgentOutput RobotAgent::tick(SteadyTime now) {
  return finish(now);
}

AgentOutput RobotAgent::body_failed(const Error& error, SteadyTime now) {
  fault_ = error.message;
  navigator_->stop();
  if (teaching_.has_value()) stop_teaching("the body failed: " + error.message, now);
  task_.set(msg::RoutePhase::failed, fault_, now);
  output_.notes.push_back("body failed: " + error.message);
  return finish(now);
}

AgentOutput RobotAgent::leave(SteadyTime now) {
  navigator_->stop();
  command_ = Twist{};
  AgentOutput last = finish(now);
  msg::RobotState off = state();
  off.mode = msg::RobotMode::off;
  off.reason = "its agent was ended";
  send(std::move(off));
  std::move(output_.send.begin(), output_.send.end(), std::back_inserter(last.send));
  output_ = {};
  return last;
}

void RobotAgent::pump(SteadyTime now) {
  for (std::string& dropped : session_.drop_claims(now)) output_.notes.push_back(std::move(dropped));
  if (std::optional<msg::Hello> own = session_.due(now)) output_.send.emplace_back(std::move(*own));
  if (now >= describe_at_) send(description());
  if (now >= describe_at_) describe_at_ = now + std::chrono::seconds(10);
  if (state_due(now)) send(state());
  if (std::optional<msg::RouteProgress> progress = task_.due(now)) send(std::move(*progress));
  if (std::optional<msg::WindowRequest> request = replica_.due(now)) send(std::move(*request));
  if (std::optional<msg::Recognise> question = recogniser_.due(now)) send(std::move(*question));
  Result<std::vector<Batch>> batches = spooler_.due(now);
  if (batches) {
    for (Batch& batch : *batches) send(msg::ExperienceBatch{.header = {}, .batch = std::move(batch)});
  } else {
    abandon_teaching(batches.error().message, now);
  }
  if (std::optional<msg::ContentRequest> request = cache_.due(now)) send(std::move(*request));
  while (spooler_.has_chunks()) {
    Result<std::optional<msg::Chunk>> chunk = spooler_.next_chunk(budget_, now);
    if (!chunk) {
      output_.notes.push_back("spool: " + chunk.error().message);
      continue;
    }
    if (!chunk->has_value()) break;
    send(std::move(**chunk));
  }
}

AgentOutput RobotAgent::finish(SteadyTime now) {
  work(now);
  pump(now);
  if (stopped_ || lost_ || !fault_.empty()) command_ = Twist{};
  output_.command = command_;
  return std::exchange(output_, AgentOutput{});
}

std::optional<SteadyTime> RobotAgent::next_tick() const {
  SteadyTime next = std::min({session_.next(), describe_at_, state_at_, replica_.next()});
  const auto sooner = [&next](const std::optional<SteadyTime>& at) {
    if (at.has_value()) next = std::min(next, *at);
  };
  sooner(task_.next());
  sooner(spooler_.next());
  sooner(cache_.next());
  sooner(recogniser_.next());
  if (spooler_.has_chunks()) sooner(budget_.when(msg::kChunkBytes));
  using Phase = Teaching::Phase;
  const bool limited =
      teaching_.has_value() && (teaching_->phase == Phase::ending || teaching_->phase == Phase::seeking ||
                                (teaching_->phase == Phase::preparing && teaching_->seed.has_value()));
  if (limited) sooner(teaching_->deadline);
  if (!keeping_.empty()) sooner(keeping_until_);
  if (keeping_alone_.has_value()) sooner(keeping_alone_->deadline);
  if (handing_in_.has_value()) sooner(handing_in_->deadline);
  if (localising_.has_value()) sooner(localising_->deadline);
  if (follow_pending_ && !stopped_ && fault_.empty() && !teaching_.has_value()) sooner(follow_at_latest_);
  return next;
}

void RobotAgent::was_away(Duration away, SteadyTime now) {
  session_.was_away(away, now);
  keeping_until_ += away;
  follow_at_latest_ += away;
  if (teaching_.has_value()) teaching_->deadline += away;
  if (keeping_alone_.has_value()) keeping_alone_->deadline += away;
  if (handing_in_.has_value()) handing_in_->deadline += away;
  if (localising_.has_value()) localising_->deadline += away;
  ++seen_["agent: away from its inbox for more than a second"];
}

Counters RobotAgent::counters() const {
  Counters all = session_.counters();
  add_to(all, replica_.counters());
  add_to(all, cache_.counters());
  add_to(all, seen_);
  return all;
}

}  // namespace weft::agents
