#include "clients/evaluate/registration/cloud_file.hpp"

#include <gmock/gmock.h>

#include "tests/clients/evaluate/parsed.hpp"

namespace weft::evaluate::registration {
namespace {

using testing::HasSubstr;

TEST(CloudFile, AMatrixIsAPoseAndWhatIsNoneIsRefused) {
  const auto pose = parse_matrix("0 -1 0 2\n1 0 0 3\n0 0 1 4\n0 0 0 1\n", "t.txt");
  ASSERT_TRUE(pose);
  EXPECT_LT((*pose * Eigen::Vector3d(1.0, 0.0, 0.0) - Eigen::Vector3d(2.0, 4.0, 4.0)).norm(), 1e-12);
  EXPECT_THAT(parse_matrix("1 0 0", "t.txt").error().message, HasSubstr("t.txt: 3 numbers"));
  EXPECT_THAT(parse_matrix("2 0 0 0 0 1 0 0 0 0 1 0", "t.txt").error().message, HasSubstr("no rotation"));
}

TEST(CloudFile, AGuessIsFourNumbers) {
  const auto guess = parse_guess("1,2,3,0.5");
  ASSERT_TRUE(guess);
  EXPECT_NEAR(project(*guess).heading, 0.5, 1e-12);
  EXPECT_EQ(guess->translation, Eigen::Vector3d(1.0, 2.0, 3.0));
  for (const char* wrong : {"", "1,2,3", "1,2,x,4", "1,2,3,4,5"}) {
    EXPECT_THAT(parse_guess(wrong).error().message, HasSubstr("X,Y,Z,HEADING")) << wrong;
  }
}

TEST(CloudFile, OtherEndingsAndMissingFilesAreRefused) {
  EXPECT_EQ(read_points("/nowhere/a.pcd").error().code, ErrorCode::not_found);
}

TEST(RegisterInvocation, FlagsAndDefaults) {
  const auto plain = std::get<RegisterOptions>(parsed({"register", "a.pcd", "b.pcd"}));
  EXPECT_EQ(plain.a, "a.pcd");
  EXPECT_EQ(plain.b, "b.pcd");
  EXPECT_TRUE(plain.truth.empty());
  const auto given =
      std::get<RegisterOptions>(parsed({"register", "a.pcd", "b.pcd", "--truth", "t", "--guess", "1,2,3,4"}));
  EXPECT_EQ(given.truth, "t");
  EXPECT_EQ(given.guess, "1,2,3,4");
  EXPECT_EQ(std::get<NotRun>(parsed({"register", "a.pcd"})).exit_code, 2);
  EXPECT_EQ(std::get<RegisterRoomsOptions>(parsed({"register-rooms"})).seeds.last, 20U);
  EXPECT_EQ(std::get<RegisterRoomsOptions>(parsed({"register-rooms", "--seeds", "3"})).seeds.first, 3U);
}

}  // namespace
}  // namespace weft::evaluate::registration
