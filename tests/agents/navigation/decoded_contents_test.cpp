#include "agents/navigation/decoded_contents.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/network/codec.hpp"
#include "tests/agents/navigation/learning_marks.hpp"

namespace weft::agents {
namespace {

static_assert(Learns<LearningMarks> && !Learns<MarksMethod>);
static_assert(newest_format<LearningMarks>() == 2 && newest_format<MarksMethod>() == 1);

class OneContent final : public Contents {
 public:
  explicit OneContent(Bytes bytes) : bytes_(std::make_shared<const Bytes>(std::move(bytes))) {}
  std::shared_ptr<const Bytes> find(const ContentHash&) const override { return bytes_; }

 private:
  std::shared_ptr<const Bytes> bytes_;
};

Place of_format(std::uint32_t format) {
  Place place;
  place.id = {ExperienceId{1}, 0};
  place.method = "marks";
  place.content_format = format;
  return place;
}

template <class M>
bool is_read(const M& method, std::uint32_t format, const Bytes& bytes) {
  DecodedContents<M> decoded(method, 1U << 20U);
  return bool(decoded.find(of_format(format), OneContent(bytes)));
}

TEST(DecodedContents, OlderFormatsAreTheMethodsOwnBusiness) {
  const Bytes bytes = MarksMethod{}.encode({});
  EXPECT_TRUE(is_read(MarksMethod{}, 1, bytes));
  EXPECT_TRUE(is_read(MarksMethod{}, 0, bytes));
  EXPECT_TRUE(is_read(LearningMarks{}, 1, bytes)) << "as it was taught";
  EXPECT_TRUE(is_read(LearningMarks{}, 2, bytes)) << "as it was learned";
}

TEST(DecodedContents, ANewerOneIsNotEvenAskedFor) {
  const MarksMethod method;
  DecodedContents<MarksMethod> decoded(method, 1U << 20U);
  const auto newer = decoded.find(of_format(2), OneContent(method.encode({})));
  ASSERT_FALSE(newer);
  EXPECT_EQ(newer.error().reason, "other_method");
  EXPECT_FALSE(is_read(LearningMarks{}, 3, method.encode({})));
}

TEST(DecodedContents, WhatTheMethodRefusesIsDamaged) {
  const MarksMethod method;
  DecodedContents<MarksMethod> decoded(method, 1U << 20U);
  const auto other = decoded.find(of_format(1), OneContent({1, 2, 3}));
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().reason, "content_damaged");
}

TEST(DecodedContents, SoManyBytesAreKeptTheLeastRecentlyUsedGoFirst) {
  class Counting final : public Contents {
   public:
    std::shared_ptr<const Bytes> find(const ContentHash& hash) const override {
      ++asked[hash.bytes[0]];
      return std::make_shared<const Bytes>(MarksMethod{}.encode({std::vector<Marks::Sighting>(1)}));
    }
    mutable std::map<int, int> asked;
  };
  const MarksMethod method;
  constexpr std::uint64_t kOne = 40;  // bytes of a content with one sighting
  DecodedContents<MarksMethod> decoded(method, 2 * kOne);
  const Counting contents;
  const auto place = [](std::uint8_t number) {
    Place one = of_format(1);
    one.content.hash.bytes[0] = number;
    return one;
  };
  for (const std::uint8_t number : std::initializer_list<std::uint8_t>{1, 2, 1, 3, 1, 2})
    ASSERT_TRUE(decoded.find(place(number), contents));
  EXPECT_EQ(contents.asked.at(1), 1) << "it was used in between";
  EXPECT_EQ(contents.asked.at(2), 2) << "3 took its room";
  EXPECT_EQ(contents.asked.at(3), 1);
  DecodedContents<MarksMethod> little(method, kOne / 2);
  ASSERT_TRUE(little.find(place(9), contents));
  ASSERT_TRUE(little.find(place(9), contents));
  EXPECT_EQ(contents.asked.at(9), 1) << "one stays, however large";
}

}  // namespace
}  // namespace weft::agents
