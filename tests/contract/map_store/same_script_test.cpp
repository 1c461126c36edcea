#include <gtest/gtest.h>

#include <algorithm>

#include "core/network/codec.hpp"
#include "tests/contract/map_store/engines.hpp"
#include "tests/storage/sample_map.hpp"

namespace weft::storage {
namespace {

/// Draws a script of commits, right and wrong ones, and restarts; writes down all that the store answers.
class Script {
 public:
  Script(std::unique_ptr<Medium> medium, std::uint64_t seed) : medium_(std::move(medium)), random_(seed) {}

  std::vector<std::string> play(int steps) {
    restart();
    for (int step = 0; step < steps; ++step) {
      if (random_.chance(0.08)) {
        restart();
      } else {
        commit(draw());
      }
    }
    restart();
    return std::move(record_);
  }

 private:
  void restart() {
    store_.reset();
    store_ = std::move(*medium_->start());
    const auto stored = store_->open();
    ASSERT_TRUE(stored) << stored.error().message;
    record_.push_back("epoch " + std::to_string(stored->epoch.value));
    for (const std::string& line : sample::describe(*stored)) record_.push_back(line);
  }

  void commit(const Transaction& transaction) {
    const auto committed = store_->commit(transaction);
    record_.push_back(committed ? "revision " + std::to_string(committed->revision.value)
                                : std::string(to_string(committed.error().code)) + ": " + committed.error().message);
  }

  sample::Delivery& delivery() {
    if (deliveries_.empty() || random_.chance(0.5)) {
      const std::size_t which = random_.below(3);
      deliveries_.push_back(runs_.at(which).next(1 + static_cast<std::uint32_t>(random_.below(4)), 50));
      if (random_.chance(0.1)) return deliveries_[random_.below(deliveries_.size())];  // the new one comes later
      return deliveries_.back();
    }
    return deliveries_[random_.below(deliveries_.size())];
  }

  PlaceId place() { return {{1 + random_.below(3)}, static_cast<std::uint32_t>(random_.below(12))}; }

  Transaction draw() {
    Transaction transaction;
    const std::uint64_t changes = 1 + random_.below(3);
    for (std::uint64_t change = 0; change < changes; ++change) {
      switch (random_.below(9)) {
        case 0:
          transaction.changes.emplace_back(PutLabel{"l" + std::to_string(random_.below(3)), place()});
          break;
        case 1:
          transaction.changes.emplace_back(PutGoal{sample::goal(random_.below(4), place())});
          break;
        case 2:
          transaction.changes.emplace_back(PutRoute{sample::route(random_.below(4), place(), place())});
          break;
        case 3: {
          const Route route = random_.chance(0.5) ? Route{} : sample::route(1, place(), place());
          transaction.changes.emplace_back(PutOccupancy{sample::robot(random_.below(3)), route, 0, 1});
          break;
        }
        case 4:
          if (random_.chance(0.3)) transaction.changes.emplace_back(SealExperience{place().experience, "silent"});
          break;
        case 5: {
          const PlaceId kept = random_.chance(0.5) ? place() : PlaceId{};
          transaction.changes.emplace_back(PutAwaitedLabel{"l" + std::to_string(random_.below(3)), kept,
                                                           sample::robot(1), sample::robot(7), random_.next(),
                                                           "anna"});
          break;
        }
        default: {
          Transaction more = sample::transaction(delivery());
          if (random_.chance(0.1)) more.changes.erase(more.changes.begin());
          transaction.changes.insert(transaction.changes.end(), more.changes.begin(), more.changes.end());
        }
      }
    }
    return transaction;
  }

  std::unique_ptr<Medium> medium_;
  Random random_;
  std::unique_ptr<MapStore> store_;
  std::vector<sample::Run> runs_{{1, 1}, {2, 2}, {3, 3}};
  std::vector<sample::Delivery> deliveries_;
  std::vector<std::string> record_;
};

TEST(MapStoreEngines, AnswerTheSameScriptAlike) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto memory = Script(make_memory_medium(), seed).play(120);
    const auto sqlite = Script(make_sqlite_medium(), seed).play(120);
    ASSERT_EQ(memory, sqlite) << "seed " << seed;
    const auto committed =
        std::count_if(memory.begin(), memory.end(), [](const auto& line) { return line.starts_with("revision "); });
    EXPECT_GT(committed, 40) << "seed " << seed << " commits too little to show anything";
  }
}

}  // namespace
}  // namespace weft::storage
