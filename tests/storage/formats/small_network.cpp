#include "tests/storage/formats/small_network.hpp"

#include <chrono>

#include "core/network/change.hpp"

namespace weft::formats::test {
namespace {

const std::map<PlaceId, Pose2>& truth() {
  static const std::map<PlaceId, Pose2> poses = {{{{0xa1}, 0}, {0.0, 0.0, 0.0}}, {{{0xa1}, 1}, {1.0, 0.0, 0.1}},
                                                 {{{0xa1}, 2}, {2.0, 0.2, 0.2}}, {{{0xa1}, 3}, {3.0, 0.5, 3.0}},
                                                 {{{0xb2}, 0}, {1.0, 0.1, 0.0}}, {{{0xb2}, 1}, {1.0, 1.0, 1.5}},
                                                 {{{0xb2}, 2}, {1.0, 2.0, 1.5}}};
  return poses;
}

Edge edge(const PlaceId& a, const PlaceId& b, Origin origin, Drivable drivable, bool spatial) {
  Edge out;
  out.id = {a, b};
  const Pose2 a_from_b = truth().at(a).inverse() * truth().at(b);
  Eigen::Matrix3d covariance;
  covariance << 4e-4, 1e-5, 0, 1e-5, 9e-4, 2e-5, 0, 2e-5, 1e-4;
  if (spatial) {
    out.a_from_b = Metric3{lift(a_from_b), Matrix6d::Identity() * 1e-4};
  } else {
    out.a_from_b = Metric2{a_from_b, covariance};
  }
  out.origin = origin;
  out.method = "floor";
  out.drivable = drivable;
  return out;
}

Batch run(std::uint64_t experience, std::uint32_t places, bool spatial) {
  using namespace std::chrono_literals;
  Batch batch;
  batch.experience = {experience};
  batch.sequence = 1;
  batch.robot.bytes.fill(static_cast<std::uint8_t>(experience));
  batch.method = "floor";
  for (std::uint32_t i = 0; i < places; ++i) {
    Place place;
    place.id = {{experience}, i};
    place.method = "floor";
    place.content.hash.bytes.fill(7);
    place.content.size = 3;
    place.robot = batch.robot;
    place.seen_at = SensorTime{i * 500ms};
    batch.places.push_back(place);
    if (i == 0) continue;
    const Origin origin = experience == 0xa1 && i == 2 ? Origin::blind : Origin::odometry;
    batch.edges.push_back(edge({{experience}, i - 1}, place.id, origin, Drivable::a_to_b, spatial));
  }
  return batch;
}

}  // namespace

SmallNetwork small_network(bool spatial) {
  Batch first = run(0xa1, 4, spatial);
  first.edges.push_back(edge({{0xa1}, 0}, {{0xa1}, 3}, Origin::stitch, Drivable::none, spatial));
  Batch second = run(0xb2, 3, spatial);
  second.edges.push_back(edge({{0xa1}, 1}, {{0xb2}, 0}, Origin::stitch, Drivable::both, spatial));
  Snapshot snapshot = with(with(Snapshot{}, first), second);
  snapshot = with_label(snapshot, "dock", {{0xb2}, 2});
  return {make_window(snapshot, WindowDefinition{}), truth()};
}

}  // namespace weft::formats::test
