#include <string>

#include "core/random.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/sample_map.hpp"

namespace weft::storage {
namespace {

/// Arranges a map of three runs, stitched to each other, that people edit at random.
class NearMaps : public StoreTest {
 protected:
  void play(int steps, std::uint64_t seed) {
    Random random(seed);
    for (int step = 0; step < steps; ++step) {
      // What cannot be is refused; that is another test's.
      if (const auto done = store_->commit(draw(random))) newest_ = done->revision.value;
    }
  }

  std::vector<std::string> look(const Snapshot& snapshot) {
    std::vector<std::string> lines = sample::describe(snapshot);
    for (const auto& [id, experience] : snapshot.experiences()) {
      lines.push_back(to_string(id) + " extent " + std::to_string(experience->extent));
      for (const Experience::StitchEnd& end : experience->stitch_ends) {
        lines.push_back("end at " + std::to_string(end.place) + " of " + std::to_string(end.stitch));
      }
    }
    return lines;
  }

  std::uint64_t newest_ = 0;

 private:
  Transaction draw(Random& random) {
    const Snapshot now = at(newest_);
    const double what = random.uniform();
    if (newest_ == 0 || what < 0.45) return batch(now, random);
    if (what < 0.55) return {{PutLabel{"l" + std::to_string(random.below(3)), place(random)}}};
    if (what < 0.65) return {{RollBack{{random.below(newest_)}}}};
    const Stretch stretch = {{1 + random.below(3)}, static_cast<std::uint32_t>(random.below(6)), 1000};
    if (what < 0.80) return {{BringBack{absent(now, {{stretch}, {}})}}};
    if (what < 0.90 || now.stitch_count() == 0) return {{TakeOut{present(now, {{stretch}, {}})}}};
    for (const auto& [id, experience] : now.experiences()) {
      if (!experience->stitches.empty()) return {{TakeOut{{{}, {experience->stitches[0].id}}}}};
    }
    return {};
  }

  Transaction batch(const Snapshot& now, Random& random) {
    sample::Delivery delivery = runs_[random.below(3)].next(1 + static_cast<std::uint32_t>(random.below(4)), 20);
    const PlaceId newer = delivery.batch.places.back().id;
    const PlaceId older = place(random);
    if (now.place(older) != nullptr && older.experience != newer.experience) {
      delivery.batch.edges.push_back(sample::stitch(older, newer));
    }
    return sample::transaction(delivery);
  }

  PlaceId place(Random& random) { return {{1 + random.below(3)}, static_cast<std::uint32_t>(random.below(12))}; }

  std::vector<sample::Run> runs_{{1, 1}, {2, 2}, {3, 3}};
};

/// Tests that it is the same map from wherever one comes.
TEST_P(NearMaps, AreTheSameAsReadWhole) {
  play(60, 7);
  ASSERT_GT(newest_, 30U);
  std::uint64_t stitches = 0;
  for (std::uint64_t revision = 0; revision <= newest_; ++revision) {
    const Snapshot whole = at(revision);
    stitches = std::max(stitches, whole.stitch_count());
    for (std::uint64_t other = 0; other <= newest_; ++other) {
      ASSERT_EQ(look(at(revision, at(other))), look(whole)) << revision << " from " << other;
    }
  }
  EXPECT_GT(stitches, 3U);
}

TEST_P(NearMaps, OverWhatWasDeletedForGoodToo) {
  play(40, 11);
  const std::uint64_t kept = newest_ / 2;
  finish(store_->compact({kept}));
  for (std::uint64_t revision = kept; revision <= newest_; ++revision) {
    for (std::uint64_t other = kept; other <= newest_; ++other) {
      ASSERT_EQ(look(at(revision, at(other))), look(at(revision))) << revision << " from " << other;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, NearMaps, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
