#include "clients/evaluate/generate/generate.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "storage/memory/memory_store.hpp"

namespace weft::evaluate {
namespace {

constexpr SitePlan kPlan{.places = 3'000, .seed = 5, .batch_places = 250};

struct Outcome {
  Result<Generated> result = fail(ErrorCode::internal, "not run");
  std::string progress;
};

/// Stops when `batches` were asked for.
Outcome generate(const std::shared_ptr<storage::MemoryDisk>& disk, const SitePlan& plan, int batches) {
  const auto store = storage::make_memory_store(disk);
  const auto stored = store->open();
  Outcome run;
  std::ostringstream progress;
  double now_s = 0.0;
  const GenerationWatch watch{progress, [&] { return now_s += 1.0; }, [&] { return batches-- == 0; }};
  if (stored) run.result = generate_site(*store, *stored, plan, watch);
  run.progress = progress.str();
  return run;
}

Snapshot::Labels labels_of(const std::shared_ptr<storage::MemoryDisk>& disk) {
  const auto stored = storage::make_memory_store(disk)->open();
  return stored ? stored->snapshot.labels() : Snapshot::Labels{};
}

TEST(GenerateSite, GoesOnWhereItStopped) {
  const auto whole = std::make_shared<storage::MemoryDisk>();
  const Outcome at_once = generate(whole, kPlan, 1000);
  ASSERT_TRUE(at_once.result) << at_once.result.error().message;
  EXPECT_TRUE(at_once.result->is_complete);
  EXPECT_EQ(at_once.result->written, 3'000U);
  EXPECT_NE(at_once.progress.find("of 3000 places"), std::string::npos);
  EXPECT_NE(at_once.progress.find("s remain"), std::string::npos);

  const auto halves = std::make_shared<storage::MemoryDisk>();
  const Outcome first = generate(halves, kPlan, 5);
  ASSERT_TRUE(first.result);
  EXPECT_FALSE(first.result->is_complete);
  const Outcome second = generate(halves, kPlan, 1000);
  ASSERT_TRUE(second.result);
  EXPECT_TRUE(second.result->is_complete);
  EXPECT_EQ(first.result->written + second.result->written, 3'000U);
  EXPECT_EQ(halves->batch_hashes, whole->batch_hashes);
  EXPECT_EQ(labels_of(halves), labels_of(whole));
  EXPECT_FALSE(labels_of(halves).empty());
  EXPECT_EQ(halves->contents.size(), 3'000U);

  const Outcome third = generate(halves, kPlan, 1000);
  ASSERT_TRUE(third.result);
  EXPECT_EQ(third.result->written, 0U);
}

TEST(GenerateSite, DoesNotMixWithAnother) {
  const auto disk = std::make_shared<storage::MemoryDisk>();
  ASSERT_TRUE(generate(disk, kPlan, 1000).result);
  SitePlan other = kPlan;
  other.content_bytes = 99;
  const Outcome mixed = generate(disk, other, 1000);
  ASSERT_FALSE(mixed.result);
  EXPECT_EQ(mixed.result.error().code, ErrorCode::conflict);
}

}  // namespace
}  // namespace weft::evaluate
