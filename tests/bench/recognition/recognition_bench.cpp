// How many of the likeliest places have to be looked at: signatures as numbers beside their codes of four bits. And
// how long a million codes are compared, beside reading them.
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <vector>

#include "agents/methods/recognition/index.hpp"
#include "core/network/change.hpp"
#include "tests/bench/times.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::bench {
namespace {

using namespace agents;

struct Seen {
  std::uint64_t floor = 0;
  Pose2 at;
};

/// Holds places 0.2 m apart on several floors, their signatures, and what other robots see there later.
struct World {
  std::vector<Seen> places;
  std::vector<Signature> signatures;
  std::vector<std::uint8_t> codes;
  UsualLevels usual;
};

FloorContent content(const Floor& method, const test::FloorCamera& eye, const test::FlatFloor& floor, const Pose2& at,
                     const test::Shot& shot) {
  return *test::look(method, eye, floor, at, {}, shot);
}

struct Looks {
  const char* name;
  double gain;
  double heading;
  std::vector<std::size_t> rank_of_numbers{};
  std::vector<std::size_t> rank_of_codes{};
};

/// Returns how many places seem likelier than every one within 0.3 m of the right spot.
std::size_t rank(const World& world, const Seen& right, const std::vector<double>& unlikeness) {
  double best = 1e18;
  for (std::size_t k = 0; k < world.places.size(); ++k) {
    const bool is_right = world.places[k].floor == right.floor &&
                          (world.places[k].at.translation() - right.at.translation()).norm() < 0.3;
    if (is_right) best = std::min(best, unlikeness[k]);
  }
  return static_cast<std::size_t>(
      std::count_if(unlikeness.begin(), unlikeness.end(), [&](double one) { return one < best; }));
}

void compare(const World& world, const Seen& right, const Signature& seen, Looks& looks) {
  std::vector<double> unlikeness;
  unlikeness.reserve(world.places.size());
  for (const Signature& signature : world.signatures) unlikeness.push_back(distance2(seen, signature));
  looks.rank_of_numbers.push_back(rank(world, right, unlikeness));
  std::vector<std::int32_t> likeness(world.places.size());
  CodeQuery(seen, world.usual).compare(world.codes, likeness);
  std::transform(likeness.begin(), likeness.end(), unlikeness.begin(), [](std::int32_t one) { return -1.0 * one; });
  looks.rank_of_codes.push_back(rank(world, right, unlikeness));
}

void print(const char* what, std::vector<std::size_t> ranks) {
  std::sort(ranks.begin(), ranks.end());
  const auto at = [&](double share) {
    return ranks[static_cast<std::size_t>(share * static_cast<double>(ranks.size() - 1))];
  };
  const auto within = [&](std::size_t most) {
    return 100.0 * static_cast<double>(std::lower_bound(ranks.begin(), ranks.end(), most) - ranks.begin()) /
           static_cast<double>(ranks.size());
  };
  std::printf("  %-8s first %5.1f %%, of 12 %5.1f %%, of 64 %5.1f %%; median %zu, 90 %% %zu, worst %zu\n", what,
              within(1), within(12), within(64), at(0.5), at(0.9), ranks.back());
}

void recall(std::uint64_t floors) {
  const CameraModel camera = test::paper_camera();
  const Floor teacher = *Floor::make({}, camera);
  const Floor other = *Floor::make({}, test::miscalibrated(camera, 9));
  const test::FloorCamera eye(camera);
  World world;
  std::vector<Looks> all{
      {"same light", 1.0, 0.0}, {"half the light", 0.5, 0.0}, {"half the light, the other way", 0.5, M_PI}};
  std::vector<std::vector<std::pair<Seen, Signature>>> questions(all.size());
  Random random(5);
  for (std::uint64_t number = 0; number < floors; ++number) {
    const test::FlatFloor floor = test::FlatFloor::procedural(100 + number, 12.0, 8.0);
    for (double y = 2.0; y < 6.1; y += 0.5) {
      for (double x = 2.0; x < 9.1; x += 0.2) {
        const Seen place{number, {x, y, 0.0}};
        world.places.push_back(place);
        world.signatures.push_back(
            *teacher.sign(content(teacher, eye, floor, place.at, {.blur = {}, .seed = world.places.size()})));
      }
    }
    for (std::size_t look = 0; look < all.size(); ++look) {
      for (std::uint64_t i = 0; i < 20; ++i) {
        const Seen right = world.places[world.places.size() - 1 - random.below(324)];
        const Pose2 middle{0.75, 0.0, 0.0};
        const Pose2 off{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                        all[look].heading + random.uniform(-0.1, 0.1)};
        const Pose2 at = right.at * middle * off * middle.inverse();
        questions[look].emplace_back(
            right,
            *other.sign(content(other, eye, floor, at, {.gain = all[look].gain, .blur = {}, .seed = 100'000 + i})));
      }
    }
  }
  const std::size_t bytes = code_bytes(512);
  world.codes.resize(world.places.size() * bytes);
  for (std::size_t k = 0; k < world.places.size(); ++k) {
    const auto code = std::span(world.codes).subspan(k * bytes, bytes);
    write_code(world.signatures[k], code);
    world.usual.count(code, 1);
  }
  std::printf("%zu places on %llu floors; the right spot among the likeliest, seen by another robot:\n",
              world.places.size(), static_cast<unsigned long long>(floors));
  for (std::size_t look = 0; look < all.size(); ++look) {
    for (const auto& [right, seen] : questions[look]) compare(world, right, seen, all[look]);
    std::printf("%s\n", all[look].name);
    print("numbers", all[look].rank_of_numbers);
    print("codes", all[look].rank_of_codes);
  }
}

/// Measures a site of long runs, a million places in all, whose signatures are random.
void a_million() {
  constexpr std::uint32_t kRuns = 100;
  constexpr std::uint32_t kPlaces = 10'000;
  RecognitionIndex index;
  Snapshot snapshot;
  Random random(1);
  Signature signature(512);
  for (std::uint64_t run = 1; run <= kRuns; ++run) {
    Batch batch;
    batch.experience = ExperienceId{run};
    batch.sequence = 1;
    for (std::uint32_t i = 0; i < kPlaces; ++i) {
      const std::uint64_t bits = random.next();
      for (std::size_t k = 0; k < signature.size(); ++k)
        signature[k] = static_cast<float>((bits * (2 * k + 1)) >> 56U);
      Place place;
      place.id = {batch.experience, i};
      index.put(place.id, signature);
      batch.places.push_back(place);
    }
    snapshot = with(snapshot, batch);
  }
  std::printf("%zu places, %.0f MB\n", index.size(), static_cast<double>(index.memory_bytes()) / 1e6);
  std::uint64_t sum = 0;
  const Took reading = timed([&] {
    for (const auto& [key, chunk] : index.chunks()) {
      for (std::size_t at = 0; at < chunk.codes.size(); at += 64) sum += chunk.codes[at];
    }
  });
  std::vector<double> pieces;
  RecognitionSearch search(index, signature, kept_for({}));
  bool goes_on = true;
  while (goes_on) {
    pieces.push_back(timed([&] { goes_on = search.step(index, snapshot, 8'192); }).processor_ms);
  }
  std::vector<PlaceId> found;
  const Took spreading = timed([&] { found = spread_out(snapshot, search.ranked(), {}); });
  std::printf("  read %.1f ms (%llu); searched %.1f ms in %zu pieces, the longest %.2f ms; %zu spread out %.2f ms\n",
              reading.processor_ms, static_cast<unsigned long long>(sum),
              std::accumulate(pieces.begin(), pieces.end(), 0.0), pieces.size(),
              *std::max_element(pieces.begin(), pieces.end()), found.size(), spreading.processor_ms);
}

}  // namespace
}  // namespace weft::bench

int main() {
  weft::bench::recall(12);
  weft::bench::a_million();
}
