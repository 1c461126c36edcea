#include "agents/perception/hamming.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace weft::agents {
namespace {

std::vector<Descriptor> random_descriptors(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Descriptor> out(count);
  for (Descriptor& d : out)
    for (std::uint64_t& word : d) word = random.next();
  return out;
}

Descriptor with_flipped(Descriptor d, int bits) {
  for (int i = 0; i < bits; ++i) d[static_cast<std::size_t>(i % 4)] ^= 1ULL << static_cast<unsigned>(i / 4);
  return d;
}

TEST(Hamming, CountsBits) {
  const Descriptor zero{};
  EXPECT_EQ(hamming(zero, zero), 0);
  EXPECT_EQ(hamming(zero, with_flipped(zero, 37)), 37);
}

TEST(Hamming, OfManyIsThatOfEach) {
  const auto to = random_descriptors(50, 4);
  const Descriptor from = random_descriptors(1, 5).front();
  const std::vector<std::uint32_t> which = {49, 0, 7, 7};
  std::vector<std::uint16_t> bits = {1, 2, 3, 4, 5};
  hamming(from, to, which, bits);
  ASSERT_EQ(bits.size(), which.size());
  for (std::size_t k = 0; k < which.size(); ++k) EXPECT_EQ(bits[k], hamming(from, to[which[k]]));
}

TEST(MatchDescriptors, FindsEachOnesOwn) {
  const auto a = random_descriptors(200, 1);
  std::vector<Descriptor> b(a.rbegin(), a.rend());
  for (Descriptor& d : b) d = with_flipped(d, 30);
  const auto matches = match_descriptors(a, b, {60, 0.9});
  ASSERT_EQ(matches.size(), 200U);
  for (const Match& m : matches) {
    EXPECT_EQ(m.a, 199 - m.b);
    EXPECT_EQ(m.distance, 30);
  }
}

TEST(MatchDescriptors, StrangersDoNotMatch) {
  EXPECT_TRUE(match_descriptors(random_descriptors(300, 1), random_descriptors(300, 2), {72, 0.9}).empty());
}

TEST(MatchDescriptors, TwinsAreAmbiguous) {
  auto a = random_descriptors(50, 3);
  const auto b = a;
  a.push_back(with_flipped(a[7], 1));
  auto noisy = b;
  for (Descriptor& d : noisy) d = with_flipped(d, 20);
  const auto matches = match_descriptors(a, noisy, {60, 0.9});
  EXPECT_EQ(matches.size(), 49U);
  for (const Match& m : matches) EXPECT_NE(m.b, 7U);
}

TEST(MatchDescriptors, OnlyCandidatesCount) {
  const auto a = random_descriptors(10, 4);
  std::vector<std::vector<std::uint32_t>> candidates(10);
  candidates[2] = {2};
  candidates[3] = {4};  // not its own
  const auto matches = match_descriptors(a, a, {60, 0.9}, candidates);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].a, 2U);
}

TEST(MatchDescriptors, NothingGivesNothing) {
  EXPECT_TRUE(match_descriptors({}, random_descriptors(5, 1), {60, 0.9}).empty());
  EXPECT_TRUE(match_descriptors(random_descriptors(5, 1), {}, {60, 0.9}).empty());
}

}  // namespace
}  // namespace weft::agents
