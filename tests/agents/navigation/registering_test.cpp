// Methods that know better than odometry how two places lie to each other.
#include "tests/agents/navigation/roamer_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::MarksWorldConfig;

/// Says that the later of two places lies a metre further on than odometry has it.
class MetreFurther : public MarksMethod {
 public:
  MetreFurther() : MarksMethod(MarksConfig{}) {}
  Relation registered(const Content& a, const Content& b, const Relation& a_from_b) const {
    if (a.sightings.empty() || b.sightings.empty()) return Metric2{};
    return compose(a_from_b, Metric2{{1.0, 0.0, 0.0}});
  }
};
static_assert(Registers<MetreFurther> && !Registers<MarksMethod>);

class Registering : public MarksFleet {
 protected:
  std::unique_ptr<Navigator> navigator() const override { return make_navigator(MetreFurther{}, navigation); }
};

TEST_F(Registering, EdgesAreAsTheMethodHasThem) {
  teach(first, Course({5, 5, 0}).straight(3.0).poses);
  const auto& chain = server.snapshot().experience(first)->chain;
  ASSERT_GT(chain.size(), 8U);
  for (const Edge& edge : chain) {
    const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
    EXPECT_NEAR(planar(edge.a_from_b).x, truly.x + 1.0, 0.02);
    EXPECT_EQ(edge.origin, Origin::odometry);
  }
}

TEST_F(Registering, ABlindEdgeStaysMarkedSo) {
  MarksWorldConfig config;
  config.blank = {{7.0, 5.0, 0.3}};
  make_world(config);
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  int blind = 0;
  for (const Edge& edge : server.snapshot().experience(first)->chain) {
    if (edge.origin != Origin::blind) continue;
    ++blind;
    const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
    EXPECT_NEAR(planar(edge.a_from_b).x, truly.x + 1.0, 0.1);
  }
  EXPECT_GE(blind, 1);
}

}  // namespace
}  // namespace weft::agents
