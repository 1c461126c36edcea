// On GRIEF's images, where they are: WEFT_DATA names the folder that holds grief-seasons.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "clients/evaluate/heading/heading_study.hpp"

namespace weft::evaluate::heading {
namespace {

namespace fs = std::filesystem;

class Seasons : public testing::Test {
 protected:
  void SetUp() override {
    const char* named = std::getenv("WEFT_DATA");
    data_ = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "grief-seasons";
    if (!fs::exists(data_))
      GTEST_SKIP() << "SKIPPED: no seasons at " << data_ << "; set WEFT_DATA to the folder that holds grief-seasons";
  }
  nlohmann::json measured(const char* set, agents::Description feature) const {
    std::ostringstream out;
    std::ostringstream progress;
    const Surroundings around{out, progress, [] { return 0.0; }, [] { return false; }};
    const Result<Ended> ended = study_heading({data_ / set, feature, true}, around);
    EXPECT_TRUE(ended) << ended.error().message;
    return nlohmann::json::parse(out.str());
  }
  fs::path data_;
};

TEST_F(Seasons, OfAYearInMichiganNearlyAllPairsAreTold) {
  const auto found = measured("michigan", agents::Description::gradients);
  EXPECT_EQ(found["pairs"], 330);
  EXPECT_GE(found["within_35_px"], 315);
  EXPECT_LT(found["median_error_px"], 10.0);
}

TEST_F(Seasons, WinterIsToldFromSummersMap) {
  const auto found = measured("planetarium", agents::Description::gradients);
  EXPECT_EQ(found["pairs"], 32);
  EXPECT_GE(found["within_35_px"], 28);
}

TEST_F(Seasons, ComparedGreysDoLessWell) {
  const auto found = measured("planetarium", agents::Description::brief);
  EXPECT_GE(found["within_35_px"], 15);
  EXPECT_LT(found["within_35_px"], measured("planetarium", agents::Description::gradients)["within_35_px"]);
}

}  // namespace
}  // namespace weft::evaluate::heading
