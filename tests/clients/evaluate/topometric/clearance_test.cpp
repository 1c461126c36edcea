#include "clients/evaluate/topometric/clearance.hpp"

#include <gmock/gmock.h>

namespace weft::evaluate::topometric {
namespace {

using agents::sim::Box;
using agents::sim::Mover;
using agents::sim::Obstacle;
using agents::sim::Site;
using testing::DoubleNear;
using testing::ElementsAre;

Moments standing_at(const Pose2& site_from_robot, std::size_t count) {
  Moments moments(count);
  for (std::size_t i = 0; i < count; ++i) {
    moments[i].site_from_robot = site_from_robot;
    moments[i].true_s = static_cast<double>(i);
  }
  return moments;
}

TEST(Clearance, IsFromTheRimToTheNearestThingThatStandsThere) {
  Site site;
  site.base.radius_m = 0.3;
  site.boxes.push_back({Box::Kind::pillar, "pillar", {3.0, 0.0, 0.0}, 1.0, 1.0, 2.0});
  Obstacle crate;
  crate.site_from_obstacle = {-1.0, 0.0, 0.0};
  crate.length_m = crate.width_m = 1.0;
  crate.from_day = 1;
  crate.to_s = 1.5;
  site.obstacles.push_back(crate);
  EXPECT_THAT(clearances_m(site, 0, standing_at({}, 1)), ElementsAre(DoubleNear(2.2, 1e-12)));
  EXPECT_THAT(clearances_m(site, 1, standing_at({}, 3)),
              ElementsAre(DoubleNear(0.2, 1e-12), DoubleNear(0.2, 1e-12), DoubleNear(2.2, 1e-12)));
}

TEST(Clearance, AMoverIsWhereItIsAtThatTime) {
  Site site;
  site.base.radius_m = 0.3;
  Mover person;
  person.way = {{-5.0, 0.0}, {-1.0, 0.0}};
  person.speed_m_s = 1.0;
  site.movers.push_back(person);
  EXPECT_THAT(clearances_m(site, 0, standing_at({}, 2)), ElementsAre(DoubleNear(4.5, 1e-9), DoubleNear(3.5, 1e-9)));
}

TEST(Clearance, AContactIsCountedWhenItBegins) {
  Moments moments = standing_at({}, 6);
  moments[1].touch = moments[2].touch = "crate";
  moments[4].touch = "wall";
  EXPECT_EQ(contacts(moments), 2.0);
}

}  // namespace
}  // namespace weft::evaluate::topometric
