#include "clients/evaluate/floor/relocalise/relocalise_study.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

class StudyOfRelocalisation : public testing::Test {
 protected:
  StudyOfRelocalisation() {
    options.site = folder.path() / "small.toml";
    // A small camera: quicker.
    std::ofstream(options.site) << "[floor]\nx_min = 0.0\ny_min = 0.0\nx_max = 20.0\ny_max = 12.8\n"
                                   "[camera]\nwidth_px = 376\nheight_px = 240\nfocal_px = 230\n"
                                   "[[robot]]\nname = \"r1\"\nx = 2.0\ny = 6.4\n";
    options.out = folder.path() / "out";
    options.kind = "asphalt";
    options.light = "same";
    options.metres = 10.0;
    options.trials = 4;
  }
  Result<Ended> run() {
    return study_relocalisation(options, {out, progress, [] { return 0.0; }, [this] { return --samples < 0; }});
  }

  storage::TemporaryDirectory folder;
  RelocaliseOptions options;
  int samples = std::numeric_limits<int>::max();  ///< until it is asked to stop
  std::ostringstream out, progress;
};

TEST_F(StudyOfRelocalisation, RobotsFindThemselvesBothWaysAndTrialsAreKept) {
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete);
  EXPECT_NE(progress.str().find("4 of 4 found, 0 WRONG"), std::string::npos) << progress.str();
  EXPECT_NE(out.str().find("forwards"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("backwards"), std::string::npos) << out.str();
  EXPECT_TRUE(std::filesystem::exists(options.out / "relocalise.csv"));
  EXPECT_TRUE(std::filesystem::exists(options.out / "floor-relocalise.png"));

  // The same again drives nothing.
  samples = 0;
  const Result<Ended> again = run();
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(*again, Ended::complete);
}

TEST_F(StudyOfRelocalisation, StopsWhenAsked) {
  samples = 3;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::stopped);
  EXPECT_FALSE(std::filesystem::exists(options.out / "relocalise.json"));
}

}  // namespace
}  // namespace weft::evaluate::floor
