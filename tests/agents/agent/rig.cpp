#include "tests/agents/agent/rig.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/network/change.hpp"
#include "core/network/codec.hpp"
#include "core/network/search.hpp"
#include "core/random.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

std::string sunk(double offset_m, std::string_view) {
  return "its camera stands " + std::to_string(std::lround(1000.0 * std::abs(offset_m))) + " mm " +
         (offset_m < 0.0 ? "lower" : "higher");
}

/// Amends every relation within the run and every second place.
class ScriptedRefiner final : public RunRefiner {
 public:
  explicit ScriptedRefiner(std::shared_ptr<Script> script) : script_(std::move(script)) {}
  Result<void> add(const Kept& kept) override {
    for (const Edge& edge : kept.edges)
      if (edge.id.a.experience == kept.place.id.experience)
        amendments_.edges.push_back({edge.id, refined(edge.a_from_b)});
    if (kept.place.id.index % 2 == 0) amendments_.places.push_back({kept.place.id, refined(kept.content)});
    return {};
  }
  bool piece() override {
    if (std::exchange(has_begun_, true)) ++done_;
    return done_ < script_->pieces;
  }
  RefineProgress progress() const override { return {done_, has_begun_ ? script_->pieces : 0}; }
  RunAmendments amendments() override {
    for (const AmendedEdge& edge : script_->spoilt.edges) amendments_.edges.push_back(edge);
    return std::move(amendments_);
  }

 private:
  std::shared_ptr<Script> script_;
  RunAmendments amendments_;
  bool has_begun_ = false;
  std::size_t done_ = 0;
};

class ScriptedNavigator final : public Navigator {
 public:
  explicit ScriptedNavigator(std::shared_ptr<Script> script) : script_(std::move(script)) {}
  std::string_view method() const override { return "marks"; }
  std::vector<std::string> teaches() const override { return script_->teaches; }

  Navigated step(const Sample& sample, const MapView&) override {
    Navigated answer = script_->answer;
    sees_ = !sample.views.empty();
    frame_ = sample.frame;
    if (sees_ && (script_->keep_wanted || (script_->teaching && script_->keep_each_step))) answer.kept = keep_all();
    return answer;
  }
  bool map_changed(const Window& before, const Window& after) override {
    if (!script_->estimate || after.place(script_->estimate->place) != nullptr) return true;
    if (before.place(script_->estimate->place) == nullptr) return true;
    for (const Reached& reached : breadth_first(before, script_->estimate->place, 100, 1000)) {
      if (after.place(reached.id) == nullptr) continue;
      script_->estimate->place = reached.id;
      return true;
    }
    return false;
  }
  void forget_taught(const Window&) override { ++script_->forgot_taught; }
  void forget_where() override { script_->estimate.reset(); }
  void begin_teach(const TeachStart& start) override {
    script_->taught.push_back(start);
    script_->teaching = true;
    script_->index = 0;
  }
  std::vector<Kept> end_teach(const MapView& /*map*/) override {
    if (!script_->teaching || !sees_) return {};
    script_->teaching = false;
    return keep_all();
  }
  bool is_taught() const override { return script_->teaching; }
  std::vector<Edge> leave_teach() override {
    script_->teaching = false;
    return std::exchange(script_->held, {});
  }
  std::unique_ptr<RunRefiner> refiner(std::string_view method) const override {
    if (!script_->refines.contains(std::string(method))) return nullptr;
    return std::make_unique<ScriptedRefiner>(script_);
  }
  void keep_place() override { script_->keep_wanted = true; }
  OrRefusal<Kept> keep_alone(const TeachStart& start, const MapView& /*map*/) override {
    if (!script_->joins) return tl::unexpected(script_->joins.error());
    script_->taught.push_back(start);
    script_->index = 0;
    Kept kept = keep(0, 0);
    ++script_->index;
    kept.edges = *script_->joins;
    for (Edge& edge : kept.edges) edge.id.b = kept.place.id;
    return kept;
  }
  void seek(const std::optional<PlaceId>& seed) override { script_->sought.push_back(seed); }
  void look_again() override { ++script_->looks; }
  void stop_looking() override { ++script_->looks_ended; }
  std::optional<Estimate> estimate() const override { return script_->estimate; }
  const Question* question() const override { return script_->question ? &*script_->question : nullptr; }
  void propose(std::uint64_t question, const std::vector<PlaceId>& places) override {
    script_->proposed.emplace_back(question, places);
    script_->question.reset();
  }
  std::optional<PlaceId> suspected() const override { return script_->suspected; }
  std::optional<PlaceId> beside() const override { return script_->beside; }
  Result<TeachReport> teach_report() const override { return script_->way; }
  std::vector<WatchedDiagnostic> watched() const override {
    return {{"height_offset_m", {0.007, 0.005}, {0.005, 0.003}, sunk, "its camera stands as high as before"}};
  }
  void believe(const Estimate& told) override { script_->estimate = told; }
  void follow(const Route& route, std::uint32_t from) override {
    script_->followed.push_back(route);
    script_->followed_from.push_back(from);
  }
  void stop() override { ++script_->stops; }

 private:
  std::vector<Kept> keep_all() {
    std::vector<Kept> all;
    for (std::size_t method = 0; method < script_->teaches.size(); ++method) all.push_back(keep(frame_, method));
    ++script_->index;
    return all;
  }
  Kept keep(std::uint64_t frame, std::size_t method) {
    script_->keep_wanted = false;
    const TeachStart& start = script_->taught.back();
    const ExperienceId experience = method == 0 ? start.experience : start.others[method - 1];
    Kept kept;
    kept.content = some_content(experience.value + script_->index, script_->content_bytes);
    kept.place = a_place(experience, script_->index, start.robot, kept.content);
    kept.place.method = script_->teaches[method];
    kept.place.frame = frame;
    if (script_->index > 0) kept.edges.push_back(an_edge({experience, script_->index - 1}, kept.place.id));
    if (method > 0) {
      kept.edges.push_back(an_edge({start.experience, script_->index}, kept.place.id));
      kept.edges.back().origin = Origin::stitch;
    }
    if (script_->joined_to) {
      kept.edges.push_back(an_edge(*std::exchange(script_->joined_to, std::nullopt), kept.place.id));
      kept.edges.back().origin = Origin::stitch;
    }
    return kept;
  }
  std::shared_ptr<Script> script_;
  bool sees_ = false;
  std::uint64_t frame_ = 0;
};

std::vector<Patch> cut(const Patch& patch, std::size_t count) {
  std::vector<Patch> parts(count);
  for (std::size_t i = 0; i < count; ++i) {
    parts[i].base = patch.base;
    parts[i].target = patch.target;
    parts[i].digest = patch.digest;
    if (i == 0) parts[i].labels = patch.labels;
  }
  for (std::size_t i = 0; i < patch.added.size(); ++i) parts[i % count].added.push_back(patch.added[i]);
  for (std::size_t i = 0; i < patch.edges.size(); ++i) parts[i % count].edges.push_back(patch.edges[i]);
  return parts;
}

}  // namespace

std::unique_ptr<Navigator> make_navigator(std::shared_ptr<Script> script) {
  return std::make_unique<ScriptedNavigator>(std::move(script));
}

Relation refined(const Relation& taught) {
  Metric2 better = std::get<Metric2>(taught);
  better.a_from_b.x += 0.01;
  return better;
}

Bytes refined(Bytes taught) {
  taught.push_back(1);
  return taught;
}

Bytes some_content(std::uint64_t seed, std::size_t size) {
  Random random(seed);
  Bytes bytes(size);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.next());
  return bytes;
}

Place a_place(ExperienceId experience, std::uint32_t index, RobotId robot, const Bytes& content) {
  Place place;
  place.id = {experience, index};
  place.method = "marks";
  place.content = {hash_bytes(content), content.size()};
  place.robot = robot;
  return place;
}

Edge an_edge(const PlaceId& a, const PlaceId& b) {
  Edge edge;
  edge.id = {a, b};
  edge.a_from_b = Metric2{Pose2{1.0, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4};
  edge.method = "marks";
  return edge;
}

Route a_route(ExperienceId experience, std::uint32_t places, std::uint8_t id) {
  Route route;
  route.goal.bytes[0] = id;
  route.id.bytes[0] = id;
  for (std::uint32_t i = 0; i < places; ++i) route.places.push_back({experience, i});
  route.relations.assign(places - 1, Metric2{Pose2{1.0, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-4});
  route.released = places - 1;
  return route;
}

msg::Header FakeServer::header() {
  return {.sender = {}, .incarnation = incarnation, .epoch = epoch, .sequence = ++sequence_, .signature = {}};
}

msg::Hello FakeServer::hello() const {
  msg::Hello hello;
  hello.peer.bytes[0] = 99;
  hello.role = msg::Role::server;
  hello.epoch = epoch;
  hello.incarnation = incarnation;
  return hello;
}

void FakeServer::restart() {
  ++epoch.value;
  ++incarnation;
  sequence_ = 0;
  waiting_.clear();
  incoming_.clear();
}

std::vector<msg::Message> FakeServer::answer(const msg::Message& message) {
  if (const auto* const asked = std::get_if<msg::Hello>(&message)) {
    msg::Hello answer = hello();
    answer.answers = {asked->challenge};
    return {answer};
  }
  if (const auto* const batch = std::get_if<msg::ExperienceBatch>(&message)) return take(batch->batch);
  if (const auto* const request = std::get_if<msg::WindowRequest>(&message)) return serve(*request);
  if (const auto* const request = std::get_if<msg::ContentRequest>(&message)) return serve(*request);
  if (const auto* const chunk = std::get_if<msg::Chunk>(&message)) {
    if (keeps_contents) take(*chunk);
    std::vector<msg::Message> answers;
    std::vector<ExperienceId> waiting;
    for (const auto& [key, batch] : waiting_) waiting.push_back(key.first);
    if (keeps_contents && contents.contains(chunk->hash)) {
      for (const ExperienceId experience : waiting) {
        if (waiting_.contains({experience, durable_through[experience] + 1})) answers = advance(experience);
      }
    }
    return answers;
  }
  return {};
}

void FakeServer::take(const msg::Chunk& chunk) {
  incoming_[chunk.hash][chunk.offset] = chunk.data;
  Bytes all;
  for (const auto& [offset, data] : incoming_[chunk.hash]) {
    if (offset != all.size()) return;
    all.insert(all.end(), data.begin(), data.end());
  }
  if (all.size() == chunk.total && hash_bytes(all) == chunk.hash) contents[chunk.hash] = all;
}

std::vector<msg::Message> FakeServer::take(const Batch& batch) {
  heard.push_back(batch);
  if (batch.sequence > durable_through[batch.experience]) waiting_[{batch.experience, batch.sequence}] = batch;
  return advance(batch.experience);
}

std::vector<msg::Message> FakeServer::advance(ExperienceId experience) {
  msg::BatchAck ack;
  ack.experience = experience;
  std::uint64_t& through = durable_through[experience];
  for (auto next = waiting_.find({experience, through + 1}); next != waiting_.end();
       next = waiting_.find({experience, through + 1})) {
    for_each_place(next->second, [&](const Place& place) {
      if (!contents.contains(place.content.hash)) ack.missing.push_back(place.content.hash);
    });
    if (!ack.missing.empty()) break;
    snapshot = with(snapshot, next->second);
    times_joined[experience] += static_cast<int>(next->second.places.size());
    if (next->second.seal) sealed.push_back(experience);
    waiting_.erase(next);
    ++through;
  }
  ack.durable_through = through;
  if (!acknowledges) return {};
  return {say(ack)};
}

std::vector<msg::Message> FakeServer::serve(const msg::WindowRequest& request) {
  const Window target = make_window(snapshot, request.definition);
  Patch patch = difference(Window{}, target);
  patch.base = Revision{};
  patch.digest = digest(target);
  const std::vector<Patch> cut_up = cut(patch, parts);
  std::vector<msg::Message> answers;
  for (std::size_t i = 0; i < cut_up.size(); ++i) {
    answers.emplace_back(say(msg::WindowPatch{.header = {},
                                              .to = {},
                                              .definition_id = request.definition_id,
                                              .part = static_cast<std::uint32_t>(i),
                                              .parts = static_cast<std::uint32_t>(cut_up.size()),
                                              .patch = cut_up[i]}));
  }
  return answers;
}

std::vector<msg::Message> FakeServer::serve(const msg::ContentRequest& request) {
  std::vector<msg::Message> answers;
  for (const msg::ContentRequest::Item& item : request.items) {
    const auto found = contents.find(item.hash);
    if (found == contents.end()) continue;
    const storage::Coded coded = coder_.encode(found->second);
    const Bytes& bytes = coded.coding == msg::Coding::raw ? found->second : coded.bytes;
    for (std::uint64_t at = item.offset; at < bytes.size(); at += msg::kChunkBytes) {
      msg::Chunk chunk;
      chunk.coding = coded.coding;
      chunk.hash = item.hash;
      chunk.total = bytes.size();
      chunk.offset = at;
      const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
      chunk.data.assign(
          begin, begin + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(msg::kChunkBytes, bytes.size() - at)));
      answers.emplace_back(say(chunk));
    }
  }
  return answers;
}

Rig::Rig()
    : disk(std::make_shared<storage::SpoolDisk>()), script(std::make_shared<Script>()), server([] {
        RobotId id;
        id.bytes.fill(7);
        return id;
      }()) {
  robot.bytes.fill(7);
  config.self = robot;
  config.name = "r1";
  config.body = "sim";
  config.can_be_taught_along = true;
  sample.views = {View{}};
  boot();
}

void Rig::boot() {
  ++config.incarnation;
  spool = storage::make_memory_spool(disk);
  auto started = start(config, make_navigator(script), *spool, Random(config.incarnation), now);
  if (started) agent = std::move(*started);
}

void Rig::restart_agent() {
  agent.reset();
  *script = Script{};
  boot();
}

void Rig::deliver(const msg::Message& message) {
  if (!connected || lost_down(message)) return;
  take(agent->handle(message, now, WallTime{1s}));
  if (doubled) take(agent->handle(message, now, WallTime{1s}));
}

void Rig::tell(const msg::Message& message) {
  take(agent->handle(message, now, WallTime{1s}));
}

void Rig::take(AgentOutput output) {
  seen.command = output.command;
  seen.fixes.insert(seen.fixes.end(), output.fixes.begin(), output.fixes.end());
  seen.acks.insert(seen.acks.end(), output.acks.begin(), output.acks.end());
  seen.notes.insert(seen.notes.end(), output.notes.begin(), output.notes.end());
  if (output.hand_stop) ++hand_stops;
  std::vector<msg::Message> answers;
  for (const msg::Message& message : output.send) {
    log.push_back(message);
    if (!connected || lost_up(message)) continue;
    for (int times = doubled ? 2 : 1; times > 0; --times) {
      for (msg::Message& answer : server.answer(message)) answers.push_back(std::move(answer));
    }
  }
  if (output.hand_start.has_value()) {
    ++hand_starts;
    hand = *output.hand_start;
  }
  for (const msg::Message& answer : answers) deliver(answer);
}

void Rig::run(Duration duration) {
  const SteadyTime end = now + duration;
  SteadyTime next_frame = now + kFrame;
  while (now < end) {
    SteadyTime next = end;
    if (body) next = std::min(next, next_frame);
    const std::optional<SteadyTime> tick = agent->next_tick();
    if (tick.has_value()) next = std::min(next, std::max(*tick, now + 1ms));
    now = next;
    if (body && now >= next_frame) {
      next_frame += kFrame;
      sample.frame = ++frame;
      if (!sample.views.empty()) sample.views.front().frame = frame;
      sample.motion.elapsed = kFrame;
      sample.motion.command = seen.command;
      take(agent->step(sample, now));
    } else {
      take(agent->tick(now));
    }
  }
}

msg::AgentCommand Rig::command(msg::AgentCommand::Kind kind, std::uint64_t number) {
  msg::AgentCommand command;
  command.kind = kind;
  command.command = number;
  return server.say(command);
}

msg::RouteOrder Rig::order(const Route& route) {
  Route ours = route;
  ours.robot = robot;
  return server.say(msg::RouteOrder{.header = {}, .to = {}, .route = ours});
}

ExperienceId lay_out(FakeServer& server, std::uint64_t experience, std::uint32_t places) {
  Batch batch;
  batch.experience = ExperienceId{experience};
  batch.sequence = 1;
  batch.method = "marks";
  for (std::uint32_t i = 0; i < places; ++i) {
    Bytes content = some_content(experience * 1000 + i, 200);
    if (i % 2 == 0) std::fill(content.begin() + 100, content.end(), std::uint8_t{0});  // shrinks
    server.contents[hash_bytes(content)] = content;
    batch.places.push_back(a_place(batch.experience, i, {}, content));
    if (i > 0) batch.edges.push_back(an_edge({batch.experience, i - 1}, {batch.experience, i}));
  }
  server.snapshot = with(server.snapshot, batch);
  return batch.experience;
}

}  // namespace weft::agents::test
