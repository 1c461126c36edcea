#include "agents/bodies/sim/hall/quad_scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>

namespace weft::agents::sim {

struct QuadScene::Embree {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  bool is_empty = true;
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

QuadScene::QuadScene(std::span<const Quad> quads) : embree_(std::make_unique<Embree>()) {
  embree_->is_empty = quads.empty();
  // What is looked at for thousands of images may take longer to prepare; what moves is there for one.
  constexpr std::size_t still = 500;
  rtcSetSceneBuildQuality(embree_->scene, quads.size() > still ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_LOW);
  if (!quads.empty()) {
    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_QUAD);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), quads.size() * 4));
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), quads.size()));
    unsigned next = 0;
    for (const Quad& quad : quads) {
      // In this order Embree's u runs along `across` and its v along `up`.
      for (const Eigen::Vector3f& p : {quad.at(0, 0), quad.at(1, 0), quad.at(1, 1), quad.at(0, 1)}) {
        vertices = std::copy(p.data(), p.data() + 3, vertices);
        *corners++ = next++;
      }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(embree_->scene);
}

QuadScene::~QuadScene() = default;
QuadScene::QuadScene(QuadScene&&) noexcept = default;
QuadScene& QuadScene::operator=(QuadScene&&) noexcept = default;

void QuadScene::cast(const Eigen::Vector3f& eye, RayPacket& packet) const {
  packet.quad.fill(-1);
  if (embree_->is_empty) return;
  alignas(64) std::array<int, kRays> valid{};
  alignas(64) RTCRayHit16 rays;  // NOLINT(cppcoreguidelines-pro-type-member-init): what is read is set below
  valid.fill(-1);
  for (std::size_t i = 0; i < kRays; ++i) {
    rays.ray.org_x[i] = eye.x();
    rays.ray.org_y[i] = eye.y();
    rays.ray.org_z[i] = eye.z();
    rays.ray.dir_x[i] = packet.x[i];
    rays.ray.dir_y[i] = packet.y[i];
    rays.ray.dir_z[i] = packet.z[i];
    rays.ray.tnear[i] = 0.0F;
    rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
    rays.ray.time[i] = 0.0F;
    rays.ray.mask[i] = ~0U;
    rays.ray.id[i] = 0;
    rays.ray.flags[i] = 0;
    rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
    rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid.data(), embree_->scene, &context, &rays);
  for (std::size_t i = 0; i < kRays; ++i) {
    const bool met = rays.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    packet.quad[i] = met ? static_cast<std::int32_t>(rays.hit.primID[i]) : -1;
    packet.u[i] = std::clamp(rays.hit.u[i], 0.0F, 1.0F);
    packet.v[i] = std::clamp(rays.hit.v[i], 0.0F, 1.0F);
    packet.distance[i] = rays.ray.tfar[i];
  }
}

float QuadScene::distance_m(const Eigen::Vector3f& eye, const Eigen::Vector3f& way) const {
  RayPacket packet;
  packet.x.fill(way.x());
  packet.y.fill(way.y());
  packet.z.fill(way.z());
  cast(eye, packet);
  return packet.quad[0] < 0 ? std::numeric_limits<float>::infinity() : packet.distance[0] * way.norm();
}

bool QuadScene::is_hidden(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const {
  constexpr float margin_m = 1e-3F;
  const Eigen::Vector3f way = to - from;
  const float length = way.norm();
  if (length <= 2.0F * margin_m) return false;
  RTCRay ray{};
  ray.org_x = from.x();
  ray.org_y = from.y();
  ray.org_z = from.z();
  ray.dir_x = way.x();
  ray.dir_y = way.y();
  ray.dir_z = way.z();
  ray.tnear = margin_m / length;
  ray.tfar = 1.0F - margin_m / length;
  ray.mask = ~0U;
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &ray);
  return ray.tfar < 0.0F;  // as Embree says that something was met
}

}  // namespace weft::agents::sim
