// On a recording of a real ceiling, where it is: WEFT_DATA names the folder that holds ceiling-cycloid.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "clients/evaluate/ceiling/frames/frames_study.hpp"

namespace weft::evaluate::ceiling {
namespace {

TEST(RealCeiling, ItsCameraIsFoundToLeanAndNoPairIsWrong) {
  const char* const named = std::getenv("WEFT_DATA");
  const std::filesystem::path folder =
      std::filesystem::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "ceiling-cycloid";
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "SKIPPED: no recording at " << folder
                 << "; set WEFT_DATA to the folder that holds ceiling-cycloid";
  std::ostringstream out;
  std::ostringstream progress;
  const Surroundings around{out, progress, [] { return 0.0; }, [] { return false; }};
  const Result<Ended> ended = study_frames({folder, true}, around);
  ASSERT_TRUE(ended) << ended.error().message;
  const auto found = nlohmann::json::parse(out.str());
  EXPECT_EQ(found["frames"], 110);
  EXPECT_NEAR(found["tilt_deg"].get<double>(), 20.0, 2.0);
  EXPECT_EQ(found["wrong_pairs"], 0);
  EXPECT_EQ(found["lost"], 0);
  EXPECT_LT(found["yaw_deg"].get<double>(), 1.5);
  EXPECT_TRUE(found.contains("rms_heights") && found.contains("rms_fitted_heights") && found.contains("yaw_deg") &&
              found.contains("lost"));
}

}  // namespace
}  // namespace weft::evaluate::ceiling
