#include "agents/navigation/recognition_query.hpp"

#include <gtest/gtest.h>

namespace weft::agents {
namespace {

const std::vector<PlaceId> kProposed{{{1}, 1}, {{1}, 2}};

Step forwards(double metres) {
  Step step;
  step.previous_from_current = Metric2{Pose2{metres, 0.0, 0.0}};
  return step;
}

struct RecognitionQueryTest : testing::Test {
  RecognitionQueryTest() { query.ask({}, "marks", 1); }
  void drive(int samples, double metres) {
    for (int i = 0; i < samples; ++i) query.advance(forwards(metres));
  }
  RecognitionQuery query;
};

TEST_F(RecognitionQueryTest, WhoDrivesOnGetsTheAnswerToWhatItAsked) {
  drive(20, 0.05);
  EXPECT_FALSE(query.is_due(false)) << "1 m on, and the answer is on its way";
  EXPECT_TRUE(query.answered(query.open()->number, kProposed.size()));
  EXPECT_TRUE(query.is_due(true)) << "it stands elsewhere by now";
}

TEST_F(RecognitionQueryTest, WhoDrivesOnAndIsNotAnsweredAsksAnew) {
  drive(200, 0.05);
  EXPECT_TRUE(query.is_due(false));
}

TEST_F(RecognitionQueryTest, WhoDrivesOnDoesNotWaitForPlacesBehindThoseTriedInVain) {
  ASSERT_TRUE(query.answered(query.open()->number, kProposed.size()));
  query.ask_on();
  drive(10, 0.05);
  EXPECT_TRUE(query.is_due(false));
}

TEST_F(RecognitionQueryTest, WhoStandsAsksOnlyOnce) {
  drive(1000, 0.0);
  EXPECT_FALSE(query.is_due(false)) << "nothing has changed, and the question is still open";
}

TEST_F(RecognitionQueryTest, WhoHasStoodForLongWithNothingToTryAsksAgain) {
  ASSERT_TRUE(query.answered(query.open()->number, 0));
  drive(100, 0.0);
  EXPECT_FALSE(query.is_due(false));
  drive(300, 0.0);
  EXPECT_FALSE(query.is_due(true));
  EXPECT_TRUE(query.is_due(false));
}

}  // namespace
}  // namespace weft::agents
