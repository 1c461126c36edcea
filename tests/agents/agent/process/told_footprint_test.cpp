#include "agents/agent/process/told_footprint.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/process/programs.hpp"
#include "tests/agents/methods/tiny/grid_filter.hpp"

namespace weft::agents::test {
namespace {

/// Steers itself: stands.
class Swerving : public tiny::GridFilter {
 public:
  Steering steer(Odometry& /*odometry*/, const Around<Swerving>* /*around*/, const Ahead& /*ahead*/) const {
    return Twist{};
  }
};

std::variant<Options, Leave> parsed_with(const std::vector<std::string>& more) {
  std::vector<const char*> argv = {"weft-agent-sim", "--name", "r1", "--state", "s", "--site", "x.toml"};
  for (const std::string& argument : more) argv.push_back(argument.c_str());
  return parse_options(kSimulator, static_cast<int>(argv.size()), argv.data());
}

TEST(ToldFootprint, OnlyAMethodThatSteersItselfLeavesItsRoute) {
  NavigationConfig navigation;
  navigation.follow.aside_m = 0.3;
  EXPECT_DOUBLE_EQ(leaves_route_by_m<Swerving>(navigation), 0.3);
  EXPECT_DOUBLE_EQ(leaves_route_by_m<tiny::GridFilter>(navigation), 0.0);
}

TEST(ToldFootprint, OfMethodsThatKeepToTheirRouteItIsTheBodys) {
  const auto result = parsed_with({"--method", "floor"});
  const auto* const options = std::get_if<Options>(&result);
  ASSERT_NE(options, nullptr) << std::get<Leave>(result).text;
  EXPECT_DOUBLE_EQ(told_footprint_m(*options), options->footprint_radius_m);
}

}  // namespace
}  // namespace weft::agents::test
