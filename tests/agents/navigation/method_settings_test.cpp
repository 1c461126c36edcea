#include "agents/navigation/method_settings.hpp"

#include <gtest/gtest.h>

#include "tests/support/marks.hpp"

namespace weft::agents {
namespace {

struct Sparse : MarksMethod {
  static constexpr std::string_view navigation_defaults = "[teach]\nspacing_m = 0.7\n[belief]\nin_plane = true\n";
};
static_assert(HasNavigationDefaults<Sparse> && !HasNavigationDefaults<MarksMethod>);

TEST(MethodSettings, AMethodBringsItsOwnAndLeavesTheRest) {
  NavigationConfig base;
  base.follow.speed_m_s = 0.4;
  const NavigationConfig sparse = navigation_defaults<Sparse>(base);
  EXPECT_EQ(sparse.teach.spacing_m, 0.7);
  EXPECT_TRUE(sparse.belief.in_plane);
  EXPECT_EQ(sparse.follow.speed_m_s, 0.4);
  EXPECT_EQ(navigation_defaults<MarksMethod>(base).teach.spacing_m, base.teach.spacing_m);
}

}  // namespace
}  // namespace weft::agents
