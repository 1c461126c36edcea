#include <gtest/gtest.h>

#include "clients/evaluate/particles/scan_map.hpp"
#include "clients/evaluate/particles/trial.hpp"
#include "tests/clients/evaluate/particles/offices.hpp"

namespace weft::evaluate::particles {
namespace {

constexpr std::uint64_t kSeeds = 3;

/// Holds what a filter is led through: steps of 1.1 m and turns of up to 1.6 rad between the scans that are located,
/// so that alphas of 0.2 spread particles by half a metre and more than half a radian each time.
class OfficesStudy : public testing::Test {
 protected:
  OfficesStudy()
      : scans_(Offices(7).driven()), grid_(grid_of_even_scans(scans_).value()), field_(field_of(grid_, {})) {}
  Course course() const {
    return {scans_, field_, anywhere_free(grid_), 0.2, [] { return 0.0; }, [] { return false; }};
  }

  std::vector<LaserScan> scans_;
  agents::OccupancyGrid grid_;
  agents::LikelihoodField field_;
};

TEST_F(OfficesStudy, AreFollowedThroughWideSteps) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::optional<Trial> trial = follow(course(), seed);
    ASSERT_TRUE(trial);
    EXPECT_FALSE(trial->row.is_lost) << "seed " << seed;
    EXPECT_LE(trial->row.mean_m, 0.1) << "seed " << seed;
    EXPECT_LE(trial->row.p95_m, 0.2) << "seed " << seed;
  }
}

TEST_F(OfficesStudy, AreFoundFromAnywhere) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const std::optional<Trial> trial = find(course(), seed);
    ASSERT_TRUE(trial);
    EXPECT_FALSE(trial->row.is_lost) << "seed " << seed;
    EXPECT_LE(trial->row.found_after, 40.0) << "seed " << seed << "; NaN: never";
  }
}

}  // namespace
}  // namespace weft::evaluate::particles
