#include "core/network/window.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "core/network/search.hpp"
#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

using support::make_network;
using support::pick_place;

WindowDefinition random_definition(Random& random, const Snapshot& snapshot) {
  WindowDefinition definition;
  if (random.chance(0.8)) definition.centre = pick_place(random, snapshot);
  definition.hops = static_cast<std::uint32_t>(random.below(8));
  definition.cap = static_cast<std::uint32_t>(1 + random.below(60));
  for (std::uint64_t i = random.below(5); i > 0; --i) definition.route.push_back(pick_place(random, snapshot));
  return definition;
}

Bytes everything(const Window& window) {
  Bytes all;
  const auto append = [&](const Bytes& bytes) { all.insert(all.end(), bytes.begin(), bytes.end()); };
  for (const auto& [id, place] : window.places) append(encode(place));
  for (const auto& [id, edge] : window.edges) append(encode(edge));
  return all;
}

void expect_same_window(const Window& a, const Window& b) {
  EXPECT_EQ(a.revision, b.revision);
  EXPECT_EQ(everything(a), everything(b));
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.ends, b.ends);
  EXPECT_EQ(a.first_end, b.first_end);
  EXPECT_EQ(digest(a), digest(b));
}

TEST(Window, IsAPureFunctionOfSnapshotAndDefinition) {
  Random random(31);
  for (int round = 0; round < 20; ++round) {
    const Snapshot snapshot = make_network(random, 3, 3, 5, 3);
    const WindowDefinition definition = random_definition(random, snapshot);
    const std::vector<Snapshot> copies{snapshot};
    expect_same_window(make_window(snapshot, definition), make_window(copies.front(), definition));
  }
}

TEST(Window, HoldsRouteThenNeighboursUpToTheCapAndEdgesInside) {
  Random random(32);
  for (int round = 0; round < 50; ++round) {
    const Snapshot snapshot = make_network(random, 3, 3, 5, 3);
    const WindowDefinition definition = random_definition(random, snapshot);
    const Window window = make_window(snapshot, definition);
    const std::set<PlaceId> route(definition.route.begin(), definition.route.end());
    for (const PlaceId& id : route) EXPECT_NE(window.place(id), nullptr);
    EXPECT_LE(window.places.size(), std::max<std::size_t>(route.size(), definition.cap));
    std::size_t edges = 0;
    for (const auto& [id, place] : window.places) {
      snapshot.for_each_edge(id, [&](const Edge& edge) {
        if (edge.id.a == id && window.place(edge.id.b) != nullptr) ++edges;
      });
    }
    EXPECT_EQ(window.edges.size(), edges);
    for (const auto& [label, place] : snapshot.labels()) {
      EXPECT_EQ(window.labels.contains(label), window.place(place) != nullptr);
    }
  }
}

TEST(Window, EdgesOfAPlaceComeAsInTheSnapshot) {
  Random random(33);
  const Snapshot snapshot = make_network(random, 4, 3, 5, 4);
  const Window window = make_window(snapshot, {std::nullopt, 0, 1000, {}});
  EXPECT_EQ(window.places.size(), snapshot.place_count());
  for (const auto& [id, place] : window.places) {
    std::vector<EdgeId> expected, visited;
    snapshot.for_each_edge(id, [&](const Edge& edge) { expected.push_back(edge.id); });
    window.for_each_edge(id, [&](const Edge& edge) { visited.push_back(edge.id); });
    EXPECT_EQ(visited, expected);
  }
}

TEST(Window, OfAnUnknownCentreIsEmptyButForTheRoute) {
  Random random(34);
  const Snapshot snapshot = make_network(random);
  const PlaceId nowhere{ExperienceId{2}, 0};
  EXPECT_TRUE(make_window(snapshot, {nowhere, 5, 100, {}}).places.empty());
  EXPECT_EQ(make_window(snapshot, {nowhere, 5, 100, {pick_place(random, snapshot), nowhere}}).places.size(), 1U);
}

TEST(Patch, TurnsOneWindowIntoTheOther) {
  Random random(35);
  for (int round = 0; round < 100; ++round) {
    Snapshot snapshot = make_network(random, 3, 2, 4, 3);
    const Window base = make_window(snapshot, random_definition(random, snapshot));
    const auto& [id, experience] = *snapshot.experiences().begin();
    snapshot = with(snapshot, support::make_batch(random, snapshot, {id, experience->robot, 3, 4, 4, "marks"}));
    snapshot = with_label(snapshot, "station1", pick_place(random, snapshot));
    const Window target = make_window(snapshot, random_definition(random, snapshot));
    const Patch patch = difference(base, target);
    const Result<Window> applied = apply(base, patch);
    ASSERT_TRUE(applied) << applied.error().message;
    expect_same_window(*applied, target);

    const std::vector<Patch> parts = split(patch, 1 + random.below(9));
    const Result<Patch> joined = join(parts);
    ASSERT_TRUE(joined);
    const Result<Window> again = apply(base, *joined);
    ASSERT_TRUE(again);
    expect_same_window(*again, target);
  }
}

TEST(Patch, FromNothingReplacesWhateverIsThere) {
  Random random(36);
  const Snapshot one = make_network(random);
  const Snapshot two = make_network(random);
  const Window target = make_window(two, {std::nullopt, 0, 1000, {}});
  const Patch fresh = difference(Window{}, target);
  EXPECT_EQ(fresh.base.value, 0U);
  const Result<Window> applied = apply(make_window(one, {std::nullopt, 0, 1000, {}}), fresh);
  ASSERT_TRUE(applied);
  expect_same_window(*applied, target);
}

TEST(Patch, BetweenEqualWindowsIsEmpty) {
  Random random(37);
  const Window window = make_window(make_network(random), {std::nullopt, 0, 1000, {}});
  const Patch patch = difference(window, window);
  EXPECT_TRUE(patch.added.empty() && patch.changed.empty() && patch.removed.empty() && patch.edges.empty() &&
              patch.edges_removed.empty() && patch.labels.empty() && patch.labels_removed.empty());
  EXPECT_EQ(split(patch, 10).size(), 1U);
}

struct TwoWindows {
  Random random{38};
  Snapshot snapshot = make_network(random);
  Window base = make_window(snapshot, {std::nullopt, 0, 1000, {}});
  Window target = make_window(with_label(snapshot, "dock", pick_place(random, snapshot)), {std::nullopt, 0, 10, {}});
  Patch patch = difference(base, target);
};

TEST(Patch, MadeFromAnotherRevisionIsStale) {
  TwoWindows w;
  w.base.revision.value -= 1;
  const Result<Window> applied = apply(w.base, w.patch);
  ASSERT_FALSE(applied);
  EXPECT_EQ(applied.error().code, ErrorCode::stale);
}

TEST(Patch, AnythingMissingOrWrongIsCorrupt) {
  const auto expect_corrupt = [](auto&& damage) {
    TwoWindows w;
    damage(w);
    const Result<Window> applied = apply(w.base, w.patch);
    ASSERT_FALSE(applied);
    EXPECT_EQ(applied.error().code, ErrorCode::corrupt);
  };
  expect_corrupt([](TwoWindows& w) { w.patch.removed.pop_back(); });
  expect_corrupt([](TwoWindows& w) { w.patch.edges_removed.pop_back(); });
  expect_corrupt([](TwoWindows& w) { w.patch.removed.push_back(w.target.places.begin()->first); });
  expect_corrupt([](TwoWindows& w) { w.patch.edges_removed.push_back(w.target.edges.begin()->first); });
  expect_corrupt([](TwoWindows& w) { w.patch.digest.bytes[3] ^= 1U; });
  expect_corrupt([](TwoWindows& w) { w.patch.labels["ghost"] = {ExperienceId{2}, 0}; });
  expect_corrupt([](TwoWindows& w) { w.patch.labels["more"] = w.target.places.begin()->first; });
  expect_corrupt([](TwoWindows& w) {
    w.patch.added.push_back(w.target.places.begin()->second);
    w.patch.added.back().content.hash.bytes[0] ^= 1U;
  });
  expect_corrupt([](TwoWindows& w) {
    w.patch.edges.push_back(w.target.edges.begin()->second);
    w.patch.edges.back().a_from_b = inverse(w.patch.edges.back().a_from_b);
  });
}

TEST(Patch, PartsKeepTheirSizeAndRefuseStrangers) {
  const TwoWindows w{};
  const std::vector<Patch> parts = split(difference(Window{}, w.base), 7);
  EXPECT_GT(parts.size(), 5U);
  std::size_t entities = 0;
  for (const Patch& part : parts) {
    const std::size_t size = part.added.size() + part.changed.size() + part.removed.size() + part.edges.size() +
                             part.edges_removed.size() + part.labels.size() + part.labels_removed.size();
    EXPECT_LE(size, 7U);
    entities += size;
    EXPECT_EQ(part.digest, digest(w.base));
  }
  EXPECT_EQ(entities, w.base.places.size() + w.base.edges.size() + w.base.labels.size());
  EXPECT_EQ(join({}).error().code, ErrorCode::corrupt);
  EXPECT_EQ(join({parts[0], w.patch}).error().code, ErrorCode::corrupt);
}

TEST(Digest, ChangesWithEveryEntityAndWithNothingElse) {
  Random random(39);
  const Window window = make_window(make_network(random), {std::nullopt, 0, 1000, {}});
  const Digest before = digest(window);
  Window other = window;
  other.revision.value += 1;  // the same places at a later revision are the same window
  EXPECT_EQ(digest(other), before);
  std::vector<Digest> seen{before};
  const auto expect_new = [&](auto&& change) {
    Window changed = window;
    change(changed);
    seen.push_back(digest(changed));
    for (std::size_t i = 0; i + 1 < seen.size(); ++i) EXPECT_NE(seen[i], seen.back());
  };
  expect_new([](Window& w) { w.places.erase_all({w.places.key_at(0)}); });
  expect_new([](Window& w) { w.places.begin()->second.entity_version += 1; });
  expect_new([](Window& w) { w.places.begin()->second.content.hash.bytes[31] ^= 1U; });
  expect_new([](Window& w) { w.edges.erase_all({w.edges.key_at(0)}); });
  expect_new([](Window& w) { w.edges.begin()->second.entity_version += 1; });
  expect_new([](Window& w) { w.edges.begin()->second.drivable = Drivable::none; });
  expect_new([](Window& w) { std::get<Metric2>(w.edges.begin()->second.a_from_b).a_from_b.x += 1e-15; });
  expect_new([](Window& w) { w.labels.erase(w.labels.begin()); });
  expect_new([](Window& w) { w.labels.begin()->second = w.places.key_at(w.places.size() - 1); });
  expect_new([](Window& w) { w = Window{}; });
}

}  // namespace
}  // namespace weft
