// How long a server with 100,000 places pauses while it works out where they lie on a floor plan: when the plan is
// registered, and again after an edit of the map; beside all of it in one go.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "core/network/change.hpp"
#include "core/network/codec.hpp"
#include "core/network/site_solver.hpp"
#include "server/service.hpp"
#include "server/site/site_frames.hpp"
#include "storage/memory/memory_store.hpp"
#include "tests/bench/times.hpp"

namespace weft::bench {
namespace {

constexpr std::uint64_t kRuns = 100;
constexpr std::uint32_t kPlaces = 1'000;
const Bytes kContent{1, 2, 3};

/// Makes one of many runs side by side, 0.5 m from place to place, each joined to the one before at every tenth
/// place.
Batch run(std::uint64_t number, Random& random) {
  Batch batch;
  batch.experience = ExperienceId{number};
  batch.sequence = 1;
  batch.robot.bytes[0] = 1;
  batch.method = "marks";
  const auto edge = [&](const PlaceId& a, const PlaceId& b, double x, double y, Origin origin) {
    Edge made;
    made.id = {a, b};
    made.origin = origin;
    made.method = batch.method;
    made.a_from_b =
        Metric2{{x + random.normal(0.0, 0.002), y + random.normal(0.0, 0.002), random.normal(0.0, 0.0005)},
                4e-6 * Eigen::Matrix3d::Identity()};
    batch.edges.push_back(made);
  };
  for (std::uint32_t i = 0; i < kPlaces; ++i) {
    Place place;
    place.id = {batch.experience, i};
    place.method = batch.method;
    place.robot = batch.robot;
    place.content = {hash_bytes(kContent), kContent.size()};
    batch.places.push_back(place);
    if (i > 0) edge({batch.experience, i - 1}, place.id, 0.5, 0.0, Origin::odometry);
    if (number > 1 && i % 10 == 0) edge({{number - 1}, i}, place.id, 0.0, 0.5, Origin::stitch);
  }
  return batch;
}

Registration hall() {
  Registration made{"hall", {}, {}};
  for (const auto& [experience, index] : {std::pair(1U, 10U), {100U, 10U}, {1U, 990U}, {100U, 990U}, {50U, 500U}}) {
    Pick pick;
    pick.name = "p" + std::to_string(made.picks.size());
    pick.place = {{experience}, index};
    pick.on_plan = {0.5 * index, 0.5 * (experience - 1.0)};
    made.picks.push_back(pick);
  }
  return made;
}

void print(const char* what, std::vector<double> pieces) {
  double sum = 0.0;
  for (const double piece : pieces) sum += piece;
  std::ranges::sort(pieces);
  std::printf("  %-36s %7.1f ms in %4zu pieces, median %.2f ms, longest %.2f ms\n", what, sum, pieces.size(),
              pieces[pieces.size() / 2], pieces.back());
}

void alone(const Snapshot& map) {
  const auto shared = std::make_shared<const Snapshot>(map);
  std::vector<double> pieces;
  SiteSolver solver(view_of(shared), hall());
  bool goes_on = true;
  while (goes_on) {
    pieces.push_back(timed([&] { goes_on = solver.step(server::kPlacesOfSitePiece); }).processor_ms);
  }
  print("solver alone", pieces);
  const SiteSolution solution = solver.take();
  std::printf("  %s\n", to_text(solution).c_str());
  const Took nearest = timed([&] { std::ignore = solution.nearest({250.0, 25.0}, 1.0); });
  std::printf("  nearest place to a point %.2f ms\n", nearest.processor_ms);
  print("solver in one go", {timed([&] { solve_site(view_of(shared), hall()); }).processor_ms});
}

/// Plays one operator and the clock.
struct Operator {
  explicit Operator(server::Service& service) : service_(service) {}

  void ask(msg::OperatorRequest request) {
    request.header.sender.bytes[0] = 9;
    request.header.incarnation = 1;
    request.header.sequence = ++sequence_;
    request.request = sequence_;
    service_.handle(request, now());
  }
  /// Lets the server do what is due for so many seconds; returns what each tick took.
  std::vector<double> ticks(double lasting_s) {
    std::vector<double> pieces;
    const double end_s = clock_s_ + lasting_s;
    while (clock_s_ < end_s) {
      clock_s_ += 0.001;
      const auto due = service_.next_tick();
      if (due && *due <= now().steady) pieces.push_back(timed([&] { service_.tick(now()); }).processor_ms);
    }
    return pieces;
  }

 private:
  server::Now now() const { return {.steady = SteadyTime(from_seconds(clock_s_)), .wall = {}}; }
  server::Service& service_;
  double clock_s_ = 1000.0;
  std::uint64_t sequence_ = 0;
};

void within_a_server() {
  const auto disk = std::make_shared<storage::MemoryDisk>();
  auto store = storage::make_memory_store(disk);
  if (!store->open()) std::exit(1);
  Random random(1);
  for (std::uint64_t number = 1; number <= kRuns; ++number) {
    Batch batch = run(number, random);
    storage::Transaction transaction;
    if (number == 1)
      transaction.changes.emplace_back(storage::PutContent{.hash = hash_bytes(kContent), .bytes = kContent});
    const ContentHash hash = hash_bytes(encode(batch));
    transaction.changes.emplace_back(storage::AppendBatch{std::move(batch), hash});
    if (const auto done = store->commit(transaction); !done) {
      std::printf("%s\n", done.error().message.c_str());
      std::exit(1);
    }
  }
  store = storage::make_memory_store(disk);
  server::ServiceConfig config;
  config.self.bytes[0] = 1;
  config.incarnation = 1;
  auto service = server::start(config, *store, Random(1), {.steady = SteadyTime(from_seconds(1000.0)), .wall = {}});
  if (!service) std::exit(1);
  alone((*service)->snapshot());
  Operator anna(**service);
  print("server without a plan", anna.ticks(5.0));
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::plan_register;
  request.registration = hall();
  anna.ask(request);
  print("server, plan registered", anna.ticks(5.0));
  if ((*service)->snapshot().registrations().empty()) std::exit(1);
  request = {};
  request.kind = msg::OperatorRequest::Kind::label;
  request.label = "dock";
  request.place = {{1}, 1};
  anna.ask(request);
  print("server, worked out after an edit", anna.ticks(5.0));
}

}  // namespace
}  // namespace weft::bench

int main() {
  weft::bench::within_a_server();
}
