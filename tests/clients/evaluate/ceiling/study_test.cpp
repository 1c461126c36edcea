#include "clients/evaluate/ceiling/study.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "clients/evaluate/ceiling/rows.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::ceiling {
namespace {

class StudyOfCeilings : public testing::Test {
 protected:
  StudyOfCeilings() {
    options.scenes = WEFT_SITES "/ceiling";
    options.recording = folder.path() / "none";
    options.out = folder.path() / "out";
    options.seeds = {4, 4};
    options.extent = {6.0, 2, true};
  }
  Result<Ended> run() {
    return study_ceiling(options, {out, progress, [] { return 0.0; }, [this] { return --samples < 0; }});
  }
  Study study() const {
    return {WEFT_VERSION, read_scenes(options.scenes, options.extent.metres)->sha256, options.recording.string(),
            options.extent};
  }
  void keep(double lateral_rms_mm) const {
    std::filesystem::create_directories(options.out);
    Rows rows;
    rows[{trial::kLine, 4}].values = {{"lateral_rms_mm", lateral_rms_mm}, {"lateral_worst_mm", 2.0}};
    rows[{trial::kFound, 4}].values = {{"found_percent", 100.0}, {"wrong", 0.0}};
    ASSERT_TRUE(write_rows(options.out, study(), rows, {}));
  }

  storage::TemporaryDirectory folder;
  CeilingOptions options;
  int samples = 0;  ///< until it is asked to stop
  std::ostringstream out, progress;
};

TEST_F(StudyOfCeilings, StopsWhenAskedAndLeavesNoTruthBehind) {
  samples = 3;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_EQ(*ended, Ended::stopped);
  EXPECT_NE(progress.str().find("no recording at"), std::string::npos) << progress.str();
  EXPECT_NE(progress.str().find("2 rows to measure, 0 of them"), std::string::npos) << progress.str();
  EXPECT_TRUE(std::filesystem::is_empty(options.out));
}

TEST_F(StudyOfCeilings, OneTrialAloneLeavesTheOthersUnmeasured) {
  options.extent.is_quick = false;
  options.trial = trial::kOther;
  samples = 3;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_NE(progress.str().find("1 rows to measure, 0 of them"), std::string::npos) << progress.str();
}

TEST_F(StudyOfCeilings, RowsThatAreThereAreNotMeasuredAgain) {
  keep(1.0);
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete);
  EXPECT_NE(out.str().find("not measured"), std::string::npos) << out.str();
  EXPECT_EQ(out.str().find("NOT MET"), std::string::npos) << out.str();
  EXPECT_TRUE(std::filesystem::exists(options.out / "ceiling.csv"));
}

TEST_F(StudyOfCeilings, ARowThatIsMissedIsTold) {
  keep(50.0);
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended) << ended.error().message;
  EXPECT_EQ(*ended, Ended::missed);
  EXPECT_NE(out.str().find("NOT MET"), std::string::npos) << out.str();
}

TEST_F(StudyOfCeilings, ScenesThatAreMissingAreNamed) {
  options.scenes = folder.path() / "no-scenes";
  const Result<Ended> ended = run();
  ASSERT_FALSE(ended);
  EXPECT_NE(ended.error().message.find("hall.toml"), std::string::npos) << ended.error().message;
}

}  // namespace
}  // namespace weft::evaluate::ceiling
