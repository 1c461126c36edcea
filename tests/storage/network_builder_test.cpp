#include "storage/network_builder.hpp"

#include <gtest/gtest.h>

#include "tests/storage/sample_map.hpp"

namespace weft::storage {
namespace {

NetworkBuilder::Head head(const sample::Delivery& delivery) {
  return {.id = delivery.batch.experience,
          .robot = delivery.batch.robot,
          .name = delivery.batch.name,
          .method = delivery.batch.method,
          .places = delivery.batch.places.size()};
}

TEST(NetworkBuilder, OrderOfRowsDoesNotMatter) {
  const auto delivery = sample::Run(5, 1).next(6);
  NetworkBuilder forwards;
  NetworkBuilder backwards;
  forwards.add(head(delivery));
  for (const Place& place : delivery.batch.places) forwards.add(place);
  for (const Edge& edge : delivery.batch.edges) forwards.add(edge);
  for (auto at = delivery.batch.edges.rbegin(); at != delivery.batch.edges.rend(); ++at) backwards.add(*at);
  for (auto at = delivery.batch.places.rbegin(); at != delivery.batch.places.rend(); ++at) backwards.add(*at);
  backwards.add(head(delivery));
  EXPECT_EQ(sample::describe(forwards.build({1})), sample::describe(backwards.build({1})));
  EXPECT_TRUE(forwards.take_damage().empty());
}

TEST(NetworkBuilder, LaterEdgeOfAPairReplacesTheEarlier) {
  const auto delivery = sample::Run(5, 1).next(3);
  NetworkBuilder builder;
  builder.add(head(delivery));
  for (const Place& place : delivery.batch.places) builder.add(place);
  for (const Edge& edge : delivery.batch.edges) builder.add(edge);
  Edge stitch = sample::stitch({{5}, 0}, {{5}, 2});
  builder.add(stitch);
  stitch.entity_version = 2;
  builder.add(stitch);
  Edge odometry = delivery.batch.edges[0];
  odometry.entity_version = 2;
  builder.add(odometry);
  const Snapshot snapshot = builder.build({1});
  const Experience& experience = *snapshot.experience({5});
  ASSERT_EQ(experience.chain.size(), 2U);
  EXPECT_EQ(experience.chain[0].entity_version, 2U);
  ASSERT_EQ(experience.stitches.size(), 1U) << "within one experience it stands once";
  EXPECT_EQ(experience.stitches[0].entity_version, 2U);
}

TEST(NetworkBuilder, RowsWithoutTheirExperienceAreNamed) {
  const auto delivery = sample::Run(5, 1).next(3);
  NetworkBuilder builder;
  for (const Place& place : delivery.batch.places) builder.add(place);
  EXPECT_EQ(builder.build({1}).place_count(), 0U);
  const auto damage = builder.take_damage();
  ASSERT_EQ(damage.size(), 1U);
  EXPECT_NE(damage[0].find("0000000000000005"), std::string::npos);
}

}  // namespace
}  // namespace weft::storage
