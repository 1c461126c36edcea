#include "tests/bench/scale/load.hpp"

#include <algorithm>

#include "core/network/codec.hpp"
#include "tests/support/network_maker.hpp"

namespace weft::bench {
namespace {
constexpr std::uint32_t kPlaces = 20;
constexpr std::size_t kTeachers = 5;
constexpr std::uint32_t kLongestRun = 2000;
}  // namespace

Load::Load(server::Service& service, double& clock_s, const Rates& rates)
    : service_(service), now_s_(clock_s), rates_(rates), random_(static_cast<std::uint64_t>(clock_s)) {
  for (std::uint32_t i = 0; i < rates.agents; ++i) {
    Agent agent;
    agent.id = support::random_id<PeerId>(random_);
    agent.at = support::pick_place(random_, service.snapshot());
    agent.next_s = now_s_ + random_.uniform() / rates.windows;
    arrive(agent.id);
    agents_.push_back(std::move(agent));
  }
  for (std::size_t i = 0; i < kTeachers; ++i) {
    Teacher teacher;
    teacher.id = support::random_id<RobotId>(random_);
    arrive(teacher.id);
    teachers_.push_back(teacher);
  }
}

server::Now Load::now() const {
  return {.steady = SteadyTime(from_seconds(now_s_)), .wall = WallTime(from_seconds(now_s_))};
}

void Load::take(const std::vector<msg::Message>& messages, const std::optional<Took>& took) {
  for (const msg::Message& message : messages) {
    const auto* const patch = std::get_if<msg::WindowPatch>(&message);
    if (patch == nullptr) continue;
    places_sent += patch->patch.added.size() + patch->patch.changed.size();
    for (Agent& agent : agents_) {
      if (agent.id != patch->to) continue;
      agent.held.revision = patch->patch.target;
      agent.held_digest = patch->patch.digest;
      if (patch->part + 1 != patch->parts) continue;
      constexpr double kBetweenPatches_s = 0.5;
      if (patch->definition_id == agent.definition && agent.is_waiting) {
        agent.is_waiting = false;
        const double waited_s = now_s_ - std::max(agent.asked_s, agent.told_s + kBetweenPatches_s);
        waits.add({1e3 * waited_s, 0.0});
        if (took) windows.add(*took);
      }
      agent.told_s = now_s_;
    }
  }
}

/// Returns how long it took; the clock has gone on by it.
Took Load::handle(const msg::Message& message) {
  std::vector<msg::Message> said;
  const Took took = timed([&] { said = service_.handle(message, now()); });
  now_s_ += took.wall_ms / 1e3;
  take(said, took);
  return took;
}

void Load::tick_if_due() {
  const auto due = service_.next_tick();
  if (!due || seconds(due->time_since_epoch()) > now_s_) return;
  std::vector<msg::Message> said;
  const Took took = timed([&] { said = service_.tick(now()); });
  now_s_ += took.wall_ms / 1e3;
  ticks.add(took);
  take(said, std::nullopt);
}

void Load::arrive(const PeerId& id) {
  msg::Hello hello;
  hello.peer = id;
  hello.incarnation = 1;
  hello.role = msg::Role::agent;
  hello.name = to_string(id).substr(0, 8);
  handle(hello);
  msg::RobotDescription description;
  description.header = {id, 1, {}, 1, {}};
  description.name = hello.name;
  description.methods = {"floor"};
  handle(description);
}

void Load::ask(Agent& agent) {
  agent.asked_s = agent.next_s;
  agent.is_waiting = true;
  agent.next_s += 1.0 / rates_.windows;
  ++agent.at.index;
  if (service_.snapshot().place(agent.at) == nullptr) agent.at = support::pick_place(random_, service_.snapshot());
  msg::WindowRequest request;
  request.header = {agent.id, 1, {}, 10 + ++agent.sequence, {}};
  request.definition_id = ++agent.definition;
  request.definition.centre = agent.at;
  request.held = agent.held.revision;
  request.held_digest = agent.held_digest;
  handle(request);
}

/// Returns the teacher's next batch. Every second place is stitched to one of the run before.
Batch Load::next_batch(Teacher& teacher, std::vector<Bytes>& contents) {
  if (!teacher.experience || teacher.places >= kLongestRun) {
    teacher.experience = {random_.next() | 1U};
    teacher.batch = teacher.places = 0;
    teacher.follows = support::pick_place(random_, service_.snapshot());
  }
  const support::BatchPlan plan{teacher.experience, teacher.id, ++teacher.batch, kPlaces, 0, "floor"};
  Batch batch = support::make_batch(random_, service_.snapshot(), plan);
  for (Place& place : batch.places) {
    Bytes content(64);
    for (std::uint8_t& byte : content) byte = static_cast<std::uint8_t>(random_.next());
    place.content = {hash_bytes(content), content.size()};
    contents.push_back(std::move(content));
    const PlaceId older = teacher.follows;
    ++teacher.follows.index;
    if (place.id.index % 2 == 1 || service_.snapshot().place(older) == nullptr) continue;
    batch.edges.push_back(support::make_stitch(random_, older, place.id, "floor"));
  }
  teacher.places += kPlaces;
  return batch;
}

void Load::teach() {
  Teacher& teacher = teachers_[next_teacher_++ % teachers_.size()];
  std::vector<Bytes> contents;
  Batch batch = next_batch(teacher, contents);
  const Revision before = service_.snapshot().revision();
  Took took = handle(
      msg::ExperienceBatch{.header = {teacher.id, 1, {}, 10 + ++teacher.sequence, {}}, .batch = std::move(batch)});
  for (const Bytes& content : contents) {
    msg::Chunk chunk;
    chunk.header = {teacher.id, 1, {}, 10 + ++teacher.sequence, {}};
    chunk.hash = hash_bytes(content);
    chunk.total = content.size();
    chunk.data = content;
    took += handle(chunk);
  }
  batches.add(took);
  if (service_.snapshot().revision() != before) ++batches_joined;
}

void Load::run(double seconds_long) {
  const double end_s = now_s_ + seconds_long;
  double next_batch_s = now_s_;
  for (Agent& agent : agents_) agent.next_s = now_s_ + random_.uniform() / rates_.windows;
  while (now_s_ < end_s) {
    Agent& next = *std::min_element(agents_.begin(), agents_.end(),
                                    [](const Agent& a, const Agent& b) { return a.next_s < b.next_s; });
    const auto tick = service_.next_tick();
    const double tick_s = tick ? seconds(tick->time_since_epoch()) : end_s;
    now_s_ = std::max(now_s_, std::min({next.next_s, next_batch_s, tick_s}));
    if (next_batch_s <= now_s_) {
      next_batch_s += 1.0 / rates_.batches;
      teach();
    } else if (next.next_s <= now_s_) {
      ask(next);
    }
    tick_if_due();
  }
}

}  // namespace weft::bench
