#include "agents/methods/recognition/code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.hpp"

namespace weft::agents {
namespace {

Signature random_signature(Random& random, std::size_t numbers) {
  Signature signature(numbers);
  for (float& number : signature) number = static_cast<float>(0.2 + 0.05 * random.normal());
  return signature;
}

/// `signature` as another view shows it: as much noise as there is to see.
Signature seen_again(const Signature& signature, Random& random) {
  Signature again = signature;
  for (float& number : again) number += static_cast<float>(0.05 * random.normal());
  return again;
}

std::int32_t likeness(const CodeQuery& query, const std::vector<std::uint8_t>& code) {
  std::array<std::int32_t, 1> one{};
  query.compare(code, one);
  return one[0];
}

TEST(Code, TakesTwoBitsANumber) {
  EXPECT_EQ(code_bytes(512), 128U);
  EXPECT_EQ(code_bytes(1024), 256U);
  EXPECT_EQ(code_bytes(32), 16U);  // no less than one block
  EXPECT_EQ(code_bytes(513), 144U);
}

TEST(Code, LevelsRiseWithTheNumber) {
  Signature rising(512);
  std::iota(rising.begin(), rising.end(), 0.0F);
  std::vector<std::uint8_t> code(code_bytes(rising.size()));
  write_code(rising, code);
  const auto level = [&](std::size_t i) { return code[i % 128] >> 2 * (i / 128) & 3; };
  EXPECT_EQ(level(0), 0);
  EXPECT_EQ(level(200), 1);
  EXPECT_EQ(level(300), 2);
  EXPECT_EQ(level(511), 3);
  for (std::size_t i = 1; i < rising.size(); ++i) EXPECT_GE(level(i), level(i - 1)) << i;
}

TEST(Code, IsTheSameWhateverTheScaleAndOffset) {
  Random random(1);
  const Signature signature = random_signature(random, 512);
  Signature louder = signature;
  for (float& number : louder) number = 4.0F * number + 3.0F;
  std::vector<std::uint8_t> code(128);
  std::vector<std::uint8_t> other(128);
  write_code(signature, code);
  write_code(louder, other);
  EXPECT_EQ(code, other);
}

TEST(Code, ASignatureOfEqualNumbersIsOneToo) {
  std::vector<std::uint8_t> code(128);
  write_code(Signature(512, 0.25F), code);
  const CodeQuery query(Signature(512, 0.5F));
  EXPECT_EQ(likeness(query, code), 0);
}

// The sums of a block must not overflow for the longest signature, however far its numbers lie.
TEST(Code, TheLongestSignatureWithTheFarthestNumbersIsMostAlikeItself) {
  Signature far(longest_signature, -1.0F);
  for (std::size_t i = 0; i < far.size(); i += 2) far[i] = 1.0F;
  Signature against = far;
  for (float& number : against) number = -number;
  std::vector<std::uint8_t> code(code_bytes(far.size()));
  const CodeQuery query(far);
  write_code(far, code);
  const std::int32_t same = likeness(query, code);
  write_code(against, code);
  EXPECT_GT(same, 0);
  EXPECT_EQ(likeness(query, code), -same);
}

TEST(Code, FindsWhatWasSeenAgainAmongMany) {
  for (const std::size_t numbers : {std::size_t{512}, std::size_t{100}}) {
    Random random(2);
    std::vector<Signature> signatures;
    std::vector<std::uint8_t> codes(300 * code_bytes(numbers));
    for (std::size_t i = 0; i < 300; ++i) {
      signatures.push_back(random_signature(random, numbers));
      write_code(signatures[i], std::span(codes).subspan(i * code_bytes(numbers), code_bytes(numbers)));
    }
    std::vector<std::int32_t> likeness(300);
    for (const std::size_t which : {0U, 17U, 299U}) {
      CodeQuery(seen_again(signatures[which], random)).compare(codes, likeness);
      const auto best = std::max_element(likeness.begin(), likeness.end()) - likeness.begin();
      EXPECT_EQ(static_cast<std::size_t>(best), which) << numbers;
    }
  }
}

}  // namespace
}  // namespace weft::agents
