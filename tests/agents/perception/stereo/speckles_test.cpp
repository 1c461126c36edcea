#include "agents/perception/stereo/speckles.hpp"

#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "core/random.hpp"

namespace weft::agents {
namespace {

TEST(Speckles, PatchesOfFewPixelsAreRemoved) {
  constexpr std::int16_t none = -1;
  std::vector<std::int16_t> values = {5,    5,    none, 9,  //
                                      5,    none, 9,    9,  //
                                      none, 40,   9,    none};
  remove_speckles(values, 4, 3, 1, none);
  const std::vector<std::int16_t> kept = {5,    5,    none, 9,  //
                                          5,    none, 9,    9,  //
                                          none, none, 9,    none};
  EXPECT_EQ(values, kept);
}

TEST(Speckles, APatchMayBendAroundAHole) {
  constexpr std::int16_t none = -1;
  std::vector<std::int16_t> ring = {1, 2,    3,   //
                                    1, none, 4,   //
                                    1, 1,    5};  // 1 and 5 differ by too much, but are joined round the hole
  const std::vector<std::int16_t> before = ring;
  remove_speckles(ring, 3, 8, 1, none);
  EXPECT_EQ(ring, before);
}

TEST(Speckles, AreThoseThatOpenCvFinds) {
  constexpr std::int16_t none = -1;
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    cv::Mat image(40, 60, CV_16S);
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x)
        image.at<std::int16_t>(y, x) = random.chance(0.2) ? none : static_cast<std::int16_t>(16 * random.below(3));
    std::vector<std::int16_t> values(image.begin<std::int16_t>(), image.end<std::int16_t>());
    remove_speckles(values, image.cols, 12, 16, none);
    cv::filterSpeckles(image, none, 11, 16);
    const std::vector<std::int16_t> theirs(image.begin<std::int16_t>(), image.end<std::int16_t>());
    EXPECT_EQ(values, theirs) << "round " << round;
  }
}

}  // namespace
}  // namespace weft::agents
