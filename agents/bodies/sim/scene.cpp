#include "agents/bodies/sim/scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "agents/bodies/sim/base.hpp"

namespace weft::agents::sim {

struct Scene::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

namespace {

constexpr std::size_t kFaces = 5;

/// Returns the corners of a box, lower four then upper four, anticlockwise from (+, -); site frame.
std::array<Eigen::Vector3f, 8> corners_of(const Box& box) {
  std::array<Eigen::Vector3f, 8> corners;
  const std::array<Eigen::Vector2d, 4> around = {{{0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}}};
  for (std::size_t i = 0; i < 8; ++i) {
    const Eigen::Vector2d& half = around[i % 4];
    const Eigen::Vector2d p = box.site_from_box * Eigen::Vector2d(half.x() * box.length_m, half.y() * box.width_m);
    corners[i] = Eigen::Vector3d(p.x(), p.y(), i < 4 ? 0.0 : box.height_m).cast<float>();
  }
  return corners;
}

constexpr std::array<std::array<unsigned, 4>, kFaces> kFaceCorners = {
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};

}  // namespace

Scene::Scene(std::vector<Box> boxes) : boxes_(std::move(boxes)), embree_(std::make_unique<Embree>()) {
  for (const Box& box : boxes_) {
    const Pose2& pose = box.site_from_box;
    turns_.push_back({pose.x, pose.y, std::cos(pose.heading), std::sin(pose.heading)});
  }
  embree_->device = rtcNewDevice("threads=1");
  embree_->scene = rtcNewScene(embree_->device);
  if (!boxes_.empty()) {
    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_QUAD);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), boxes_.size() * 8));
    auto* faces = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                                                                 4 * sizeof(unsigned), boxes_.size() * kFaces));
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      for (const Eigen::Vector3f& corner : corners_of(boxes_[b])) {
        for (int axis = 0; axis < 3; ++axis) {
          *vertices++ = corner[axis];
        }
      }
      for (const auto& face : kFaceCorners) {
        for (const unsigned corner : face) {
          *faces++ = static_cast<unsigned>(b) * 8 + corner;
        }
      }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(embree_->scene);
}

Scene::~Scene() = default;

void Scene::cast(const Eigen::Vector3d& eye, std::span<const Eigen::Vector3f> directions,
                 std::span<BoxHit> hits) const {
  std::array<Eigen::Vector3f, kPacket> eyes;
  eyes.fill(eye.cast<float>());
  cast(std::span(eyes).first(directions.size()), directions, hits);
}

void Scene::cast(std::span<const Eigen::Vector3f> eyes, std::span<const Eigen::Vector3f> directions,
                 std::span<BoxHit> hits) const {
  alignas(64) std::array<int, kPacket> valid{};
  alignas(64) RTCRayHit16 packet{};
  for (std::size_t i = 0; i < kPacket; ++i) {
    const bool used = i < directions.size();
    valid[i] = used ? -1 : 0;
    const Eigen::Vector3f from = used ? eyes[i] : Eigen::Vector3f(0.0F, 0.0F, 1.0F);
    const Eigen::Vector3f direction = used ? directions[i] : Eigen::Vector3f(0.0F, 0.0F, 1.0F);
    packet.ray.org_x[i] = from.x();
    packet.ray.org_y[i] = from.y();
    packet.ray.org_z[i] = from.z();
    packet.ray.dir_x[i] = direction.x();
    packet.ray.dir_y[i] = direction.y();
    packet.ray.dir_z[i] = direction.z();
    packet.ray.tnear[i] = 0.0F;
    packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
    packet.ray.time[i] = 0.0F;
    packet.ray.mask[i] = ~0U;
    packet.ray.id[i] = 0;
    packet.ray.flags[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid.data(), embree_->scene, &context, &packet);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    hits[i] = {};
    // The floor lies at z = 0: what a ray meets under it is not seen.
    if (packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
      const auto prim = static_cast<std::int32_t>(packet.hit.primID[i]);
      hits[i] = {prim / static_cast<std::int32_t>(kFaces), prim % static_cast<std::int32_t>(kFaces),
                 packet.ray.tfar[i]};
    }
  }
}

FacePlane Scene::plane_of(std::int32_t box_index, std::int32_t face, const Eigen::Vector3d& eye) const {
  const Box& box = boxes_[static_cast<std::size_t>(box_index)];
  const Turn& turn = turns_[static_cast<std::size_t>(box_index)];
  const Eigen::Vector2d ahead(turn.cosine, turn.sine);
  const Eigen::Vector2d left(-turn.sine, turn.cosine);
  FacePlane plane;
  plane.middle = {turn.x, turn.y};
  plane.top = face == 4;
  if (plane.top) {
    plane.normal = Eigen::Vector3f::UnitZ();
    plane.ahead = static_cast<float>(box.height_m) - static_cast<float>(eye.z());
    plane.along = ahead;
    return plane;
  }
  const bool across = face % 2 == 1;
  const Eigen::Vector2d& normal = across ? left : ahead;
  const Eigen::Vector2d from = in_box(box_index, eye.x(), eye.y());
  const double half = (across ? box.width_m : box.length_m) / 2 * (face < 2 ? 1.0 : -1.0);
  plane.normal = Eigen::Vector3d(normal.x(), normal.y(), 0.0).cast<float>();
  plane.ahead = static_cast<float>(half - (across ? from.y() : from.x()));
  plane.along = across ? ahead : left;
  return plane;
}

std::vector<std::int32_t> Scene::boxes_near(double x, double y, double reach_m) const {
  std::vector<std::int32_t> near;
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    if (distance_to(boxes_[b], x, y) < reach_m) {
      near.push_back(static_cast<std::int32_t>(b));
    }
  }
  return near;
}

bool Scene::crosses(std::int32_t box_index, double eye_x, double eye_y, double x, double y) const {
  const Box& box = boxes_[static_cast<std::size_t>(box_index)];
  const Eigen::Vector2d a = in_box(box_index, eye_x, eye_y);
  const Eigen::Vector2d b = in_box(box_index, x, y);
  const Eigen::Vector2d half(box.length_m / 2, box.width_m / 2);
  double enter = 0.0;
  double leave = 1.0;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double way = b[axis] - a[axis];
    if (std::abs(way) < 1e-12) {
      if (std::abs(a[axis]) > half[axis]) {
        return false;
      }
      continue;
    }
    const double t0 = (-half[axis] - a[axis]) / way;
    const double t1 = (half[axis] - a[axis]) / way;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

}  // namespace weft::agents::sim
