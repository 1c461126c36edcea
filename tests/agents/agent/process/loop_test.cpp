#include "agents/agent/process/loop.hpp"

#include <gtest/gtest.h>
#include <spdlog/sinks/null_sink.h>
#include <spdlog/sinks/ringbuffer_sink.h>

#include <chrono>
#include <limits>
#include <optional>
#include <thread>
#include <utility>

#include "agents/agent/process/records.hpp"
#include "core/random.hpp"
#include "idl/bus/inprocess/net.hpp"
#include "process/clocks.hpp"
#include "process/health_file.hpp"
#include "tests/agents/agent/process/folder.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

/// Gives frames of 10 ms; breaks down after so many.
class Clockwork final : public Body {
 public:
  explicit Clockwork(std::uint64_t frames) : frames_(frames) {}
  Result<Sample> step(const Twist& command) override {
    commands.push_back(command);
    if (frame_ == stalls_at) std::this_thread::sleep_for(1100ms);
    if (frame_ == frames_) return fail(ending, "recording is over");
    Sample sample;
    sample.frame = ++frame_;
    sample.time = SensorTime{10ms * static_cast<std::int64_t>(frame_)};
    sample.motion = {10ms, command, std::nullopt};
    return sample;
  }
  Result<void> drive_by_hand(const std::vector<SitePoint>&) override { return fail(ErrorCode::refused, "no hand"); }
  void stop_hand() override { ++hand_stops; }
  Result<void> expose(const std::string& camera, const Exposure& exposure) override {
    exposed.emplace_back(camera, exposure.time_s);
    if (!can_be_told) return Body::expose(camera, exposure);
    return {};
  }
  Rig rig() const override { return {}; }
  std::string kind() const override { return "clockwork"; }

  std::vector<Twist> commands;
  int hand_stops = 0;
  std::vector<std::pair<std::string, double>> exposed;
  bool can_be_told = true;
  ErrorCode ending = ErrorCode::unavailable;
  std::optional<std::uint64_t> stalls_at;  ///< after that frame it keeps its caller waiting for more than a second

 private:
  std::uint64_t frames_;
  std::uint64_t frame_ = 0;
};

/// Commands its frame's number, and asks for a hand at its first sample.
class Echo final : public Agent {
 public:
  AgentOutput handle(const msg::Message&, SteadyTime, WallTime) override { return {}; }
  AgentOutput tick(SteadyTime) override { return {}; }
  std::optional<SteadyTime> next_tick() const override { return std::nullopt; }
  void was_away(Duration away, SteadyTime) override { absences.emplace_back(frames.size(), away); }
  AgentOutput step(const Sample& sample, SteadyTime now) override {
    frames.push_back(sample.frame);
    times.push_back(now);
    AgentOutput output;
    output.command.linear_m_s = static_cast<double>(sample.frame);
    if (sample.frame == 1) output.hand_start.emplace();
    output.acks = std::exchange(acks, {});
    if (sample.frame == arrives_at) {
      driven.reset();
      output.notes.emplace_back("it has arrived");
    }
    if (sample.frame > arrives_at) output.notes.emplace_back("it rests");
    if (sample.frame % 2 == 0)
      output.exposes = ExposureWish{"forward", {0.001 * static_cast<double>(sample.frame), 1.0}};
    return output;
  }
  AgentOutput body_failed(const Error& error, SteadyTime) override {
    failure = error.message;
    return {};
  }
  AgentOutput leave(SteadyTime) override {
    ++leaves;
    return {};
  }
  AgentOutput hand_answered(const Result<void>& answer, SteadyTime) override {
    hand_answer = answer.error().message;
    AgentOutput output;
    output.hand_stop = true;
    output.command.linear_m_s = 1.0;
    return output;
  }
  const Window& window() const override { return window_; }
  std::optional<Route> route() const override { return driven; }
  std::optional<Estimate> estimate() const override { return std::nullopt; }
  std::map<std::string, std::uint64_t> counters() const override { return {}; }
  std::string trouble() const override { return wrong; }

  std::vector<std::uint64_t> frames;
  std::vector<SteadyTime> times;
  std::string failure;
  int leaves = 0;
  std::string hand_answer;
  std::vector<std::pair<std::size_t, Duration>> absences;  ///< after how many frames, how long
  std::vector<AckRecord> acks;                             ///< to go out with the next sample
  std::optional<Route> driven;
  std::uint64_t arrives_at = std::numeric_limits<std::uint64_t>::max();  ///< frame
  std::string wrong;                                                     ///< its trouble

 private:
  Window window_;
};

struct Bench {
  explicit Bench(std::uint64_t frames) : Bench(frames, std::make_shared<spdlog::sinks::null_sink_mt>()) {}
  Bench(std::uint64_t frames, spdlog::sink_ptr sink)
      : net(Random(1)),
        link(net.attach(msg::Role::agent, id())),
        body(frames),
        log("weft-agent", process::LogFormat::text, std::move(sink)) {}
  static PeerId id() {
    PeerId peer;
    peer.bytes.fill(7);
    return peer;
  }
  Result<void> run(double pace, Records* records = nullptr) {
    return Loop({.agent = agent, .body = body, .link = link, .records = records, .log = log}, pace).until([this] {
      return !agent.failure.empty();
    });
  }

  bus::InProcessNet net;
  bus::Link link;
  Clockwork body;
  Echo agent;
  process::Log log;
};

TEST(AgentLoop, EverySampleLeadsToTheNextCommand) {
  Bench bench(50);
  EXPECT_TRUE(bench.run(0.0));
  ASSERT_EQ(bench.agent.frames.size(), 50U);
  for (std::size_t i = 0; i < bench.body.commands.size(); ++i) {
    EXPECT_EQ(bench.body.commands[i].linear_m_s, static_cast<double>(i));
  }
  EXPECT_EQ(bench.agent.failure, "recording is over");
}

TEST(AgentLoop, TheLastWordIsSaidWhenItEnds) {
  Bench bench(2);
  EXPECT_TRUE(bench.run(0.0));
  EXPECT_EQ(bench.agent.leaves, 1);
}

TEST(AgentLoop, NeverRunsAheadOfItsPace) {
  Bench bench(20);
  const SteadyTime began{std::chrono::steady_clock::now().time_since_epoch()};
  EXPECT_TRUE(bench.run(2.0));
  ASSERT_EQ(bench.agent.times.size(), 20U);
  // A sample is asked for when the one before it is due.
  for (std::size_t i = 1; i < 20; ++i)
    EXPECT_GE(bench.agent.times[i], began + 5ms * static_cast<std::int64_t>(i - 1));
}

TEST(AgentLoop, DamagedDataIsSaidAtTheEndToo) {
  Bench bench(2);
  bench.body.ending = ErrorCode::corrupt;
  const Result<void> ended = bench.run(0.0);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().message, "recording is over");
}

TEST(AgentLoop, RecordsThatAreLostAreSaidAtTheEndToo) {
  const Folder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "acks.jsonl");
  auto records = Records::open(folder.path(), "r1");
  ASSERT_TRUE(records.has_value());
  Bench bench(2);
  bench.agent.acks.push_back({.experience = {0xA1}, .sequence = 1, .first = 0, .places = 1});
  const Result<void> ended = bench.run(0.0, &*records);
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().code, ErrorCode::exhausted);
}

TEST(AgentLoop, AWishForAnExposureGoesToTheBody) {
  Bench bench(4);
  EXPECT_TRUE(bench.run(0.0));
  using Told = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(bench.body.exposed, (Told{{"forward", 0.002}, {"forward", 0.004}}));
}

TEST(AgentLoop, ABodyThatCannotBeToldHowToExposeDrivesOnAndThatIsSaidOnce) {
  const auto said = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(16);
  Bench bench(6, said);
  bench.body.can_be_told = false;
  EXPECT_TRUE(bench.run(0.0));
  EXPECT_EQ(bench.agent.frames.size(), 6U);
  int times = 0;
  for (const std::string& line : said->last_formatted())
    times += line.find("body clockwork cannot be told how its sensor forward exposes") != std::string::npos ? 1 : 0;
  EXPECT_EQ(times, 1);
}

TEST(AgentLoop, TheAgentIsToldThatTheLoopWasAwayBeforeItsNextSample) {
  Bench bench(4);
  bench.body.stalls_at = 2;
  EXPECT_TRUE(bench.run(0.0));
  ASSERT_FALSE(bench.agent.absences.empty());
  EXPECT_EQ(bench.agent.absences.front().first, 3U);
  EXPECT_GT(bench.agent.absences.front().second, 1s);
}

TEST(AgentLoop, ShowsThatItTurnsAndThatItsBodyFailed) {
  const Folder folder;
  Bench bench(150);
  process::Vitals vitals(
      "weft-agent", folder.path(), [](const std::string& text) { ADD_FAILURE() << text; },
      process::ServiceManager("", {}), process::steady_now());
  vitals.ready(process::steady_now());
  bool was_healthy = false;
  const auto stop = [&] {
    const process::Verdict verdict = process::look_at_health(folder.path(), process::steady_now());
    was_healthy = was_healthy || (verdict.healthy && bench.agent.frames.size() > 110);
    return !verdict.healthy;
  };
  EXPECT_TRUE(Loop({.agent = bench.agent,
                    .body = bench.body,
                    .link = bench.link,
                    .records = nullptr,
                    .log = bench.log,
                    .server = {},
                    .vitals = &vitals},
                   1.0)
                  .until(stop));
  EXPECT_TRUE(was_healthy);
  EXPECT_NE(
      process::look_at_health(folder.path(), process::steady_now()).why.find("the body failed: recording is over"),
      std::string::npos);
}

TEST(AgentLoop, LinesOfAGoalNameIt) {
  const auto said = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(16);
  Bench bench(2, said);
  bench.agent.driven.emplace();
  bench.agent.driven->goal.bytes.fill(0xA5);
  EXPECT_TRUE(bench.run(0.0));
  const std::vector<std::string> lines = said->last_formatted();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("body: recording is over (goal a5a5a5a5"), std::string::npos) << lines[0];
}

TEST(AgentLoop, TheLineWithWhichAGoalEndsNamesItAndTheNextDoesNot) {
  const auto said = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(16);
  Bench bench(5, said);
  bench.agent.driven.emplace();
  bench.agent.driven->goal.bytes.fill(0xA5);
  bench.agent.arrives_at = 3;
  EXPECT_TRUE(bench.run(0.0));
  const std::vector<std::string> lines = said->last_formatted();
  ASSERT_GE(lines.size(), 2U);
  EXPECT_NE(lines[0].find("it has arrived (goal a5a5a5a5"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find("it rests"), std::string::npos) << lines[1];
  EXPECT_EQ(lines[1].find("goal"), std::string::npos) << lines[1];
}

TEST(AgentLoop, ItsHealthShowsWhatTheAgentCannotDo) {
  const Folder folder;
  Bench bench(3000);
  bench.agent.wrong = "its spool refuses what it is to keep: the disk is full";
  process::Vitals vitals(
      "weft-agent", folder.path(), [](const std::string& text) { ADD_FAILURE() << text; },
      process::ServiceManager("", {}), process::steady_now());
  vitals.ready(process::steady_now());
  const auto why = [&] { return process::look_at_health(folder.path(), process::steady_now()).why; };
  const auto stop = [&] {
    return !bench.agent.failure.empty() || why().find("its spool refuses") != std::string::npos;
  };
  EXPECT_TRUE(Loop({.agent = bench.agent,
                    .body = bench.body,
                    .link = bench.link,
                    .records = nullptr,
                    .log = bench.log,
                    .server = {},
                    .vitals = &vitals},
                   1.0)
                  .until(stop));
  EXPECT_NE(why().find("the disk is full"), std::string::npos);
}

TEST(AgentLoop, HandsAnswerGoesBackToTheAgent) {
  Bench bench(2);
  EXPECT_TRUE(bench.run(0.0));
  EXPECT_EQ(bench.agent.hand_answer, "no hand");
  EXPECT_EQ(bench.body.hand_stops, 1);
}

}  // namespace
}  // namespace weft::agents::test
