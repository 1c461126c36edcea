#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/navigation/run_refiner.hpp"
#include "core/network/network.hpp"
#include "storage/content_coder.hpp"
#include "storage/spool/memory_spool.hpp"

namespace weft::agents::test {

/// Scripts a navigator that does what the test says and remembers what it was told.
struct Script {
  std::optional<Estimate> estimate;
  Navigated answer;  ///< of every step; `kept` is added while teaching
  bool keep_each_step = true;
  std::size_t content_bytes = 100;

  std::vector<std::string> teaches{"marks"};  ///< a place of each is kept at once, the first's joined to the others'
  std::set<std::string> refines;              ///< those of them that refine
  std::size_t pieces = 5;                     ///< of each refinement, after the one that begins it
  RunAmendments spoilt;                       ///< amendments beside the right ones
  std::vector<TeachStart> taught;
  bool teaching = false;
  bool keep_wanted = false;
  std::uint32_t index = 0;
  std::optional<PlaceId> joined_to;  ///< by a stitch: what is kept next while teaching
  OrRefusal<std::vector<Edge>> joins = tl::unexpected(Refusal{"few_inliers"});  ///< of a place kept alone
  std::vector<std::optional<PlaceId>> sought;
  std::vector<Route> followed;
  std::vector<std::uint32_t> followed_from;  ///< one for each of these
  std::optional<Question> question;
  std::vector<std::pair<std::uint64_t, std::vector<PlaceId>>> proposed;
  std::optional<PlaceId> suspected;
  std::optional<PlaceId> beside;
  std::vector<Edge> held;  ///< back until teaching is left
  int stops = 0;
  int looks = 0;        ///< again, while believing what it believes
  int looks_ended = 0;  ///< in vain
  int forgot_taught = 0;
  Result<TeachReport> way = fail(ErrorCode::refused, "nothing has been taught since its agent started");
};
std::unique_ptr<Navigator> make_navigator(std::shared_ptr<Script> script);

/// Returns what the script's refinement makes of a relation within a run, and of a content.
Relation refined(const Relation& taught);
Bytes refined(Bytes taught);

/// Plays the least server that an agent can work with. It takes what it is sent unless `keeps` says otherwise.
class FakeServer {
 public:
  explicit FakeServer(RobotId robot) : robot_(robot) {}

  std::vector<msg::Message> answer(const msg::Message& message);
  msg::Hello hello() const;
  template <class M>
  M say(M message) {
    message.header = header();
    if constexpr (requires { message.to; }) message.to = robot_;
    return message;
  }
  msg::Header header();
  void restart();

  Epoch epoch{1};
  std::uint64_t incarnation = 11;
  std::size_t parts = 1;       ///< of each patch
  bool keeps_contents = true;  ///< proactively sent ones; otherwise it asks
  bool acknowledges = true;
  Snapshot snapshot;
  std::vector<Batch> heard;  ///< each time that it was sent
  std::map<ContentHash, Bytes> contents;
  std::map<ExperienceId, std::uint64_t> durable_through;
  std::vector<ExperienceId> sealed;
  std::map<ExperienceId, int> times_joined;  ///< places, to find what is taken twice

 private:
  std::vector<msg::Message> take(const Batch& batch);
  std::vector<msg::Message> advance(ExperienceId experience);
  std::vector<msg::Message> serve(const msg::WindowRequest& request);
  std::vector<msg::Message> serve(const msg::ContentRequest& request);
  void take(const msg::Chunk& chunk);

  RobotId robot_;
  std::uint64_t sequence_ = 0;
  std::map<std::pair<ExperienceId, std::uint64_t>, Batch> waiting_;
  std::map<ContentHash, std::map<std::uint64_t, Bytes>> incoming_;
  storage::ContentCoder coder_;
};

/// Puts an experience of `places` places one metre apart into the server's network, with contents.
ExperienceId lay_out(FakeServer& server, std::uint64_t experience, std::uint32_t places);

/// Holds one agent, one server, a virtual clock, and a wire that loses and doubles what the test wants.
class Rig {
 public:
  Rig();
  /// Starts a new agent process on the same disk.
  void restart_agent();
  /// Runs both for that long, stepping the body every `kFrame` when it is switched on.
  void run(Duration duration);
  /// Tells the agent one message, now.
  void tell(const msg::Message& message);
  void take(AgentOutput output);

  template <class M>
  std::vector<M> sent() const {
    std::vector<M> found;
    for (const msg::Message& message : log) {
      if (const M* const one = std::get_if<M>(&message)) found.push_back(*one);
    }
    return found;
  }
  template <class M>
  std::optional<M> last() const {
    const std::vector<M> all = sent<M>();
    return all.empty() ? std::nullopt : std::optional<M>(all.back());
  }
  msg::AgentCommand command(msg::AgentCommand::Kind kind, std::uint64_t number);
  msg::RouteOrder order(const Route& route);
  ExperienceId lay_out(std::uint64_t experience, std::uint32_t places) {
    return test::lay_out(server, experience, places);
  }

  static constexpr Duration kFrame = std::chrono::milliseconds(100);
  RobotId robot;
  std::shared_ptr<storage::SpoolDisk> disk;
  std::unique_ptr<storage::Spool> spool;
  std::shared_ptr<Script> script;
  AgentConfig config;
  FakeServer server;
  std::unique_ptr<Agent> agent;
  SteadyTime now{};
  std::uint64_t frame = 0;
  bool body = true;
  Sample sample;  ///< template of each frame
  std::function<bool(const msg::Message&)> lost_up = [](const auto&) { return false; };
  std::function<bool(const msg::Message&)> lost_down = [](const auto&) { return false; };
  bool doubled = false;
  bool connected = true;

  std::vector<msg::Message> log;  ///< everything the agent sent
  AgentOutput seen;               ///< accumulated records, last command
  int hand_starts = 0;
  int hand_stops = 0;
  std::vector<SitePoint> hand;

 private:
  void boot();
  void deliver(const msg::Message& message);
};

Place a_place(ExperienceId experience, std::uint32_t index, RobotId robot, const Bytes& content);
Edge an_edge(const PlaceId& a, const PlaceId& b);
Bytes some_content(std::uint64_t seed, std::size_t size);
Route a_route(ExperienceId experience, std::uint32_t places, std::uint8_t id);

}  // namespace weft::agents::test
