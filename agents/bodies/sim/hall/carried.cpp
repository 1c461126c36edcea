#include "agents/bodies/sim/hall/carried.hpp"

#include <cmath>

#include "agents/bodies/sim/hall/quad_scene.hpp"

namespace weft::agents::sim {

Carried::Carried(const SampledRays& rays, const CameraModel& camera, std::span<const Quad> in_robot) {
  if (in_robot.empty()) return;
  const std::size_t pixels = rays.length.size();
  cover.assign(pixels, 0.0F);
  grey.assign(pixels, 0.0F);
  const QuadScene scene(in_robot);
  const Eigen::Vector3f eye = camera.robot_from_camera.translation.cast<float>();
  const Eigen::Matrix3f turn = camera.robot_from_camera.rotation.toRotationMatrix().cast<float>();
  for (std::size_t from = 0; from < pixels; from += kRays) {
    for (std::size_t k = 0; k < kHallSamples; ++k) {
      RayPacket packet;
      for (std::size_t i = 0; i < kRays; ++i) {
        const Eigen::Vector3f way = turn * Eigen::Vector3f(rays.x[k][from + i], rays.y[k][from + i], 1.0F);
        packet.x[i] = way.x();
        packet.y[i] = way.y();
        packet.z[i] = way.z();
      }
      scene.cast(eye, packet);
      for (std::size_t i = 0; i < kRays; ++i) {
        if (packet.quad[i] < 0) continue;
        const Quad& quad = in_robot[static_cast<std::size_t>(packet.quad[i])];
        // Faces that look towards x are a little lighter than those beside them, as under lamps.
        const float light = 0.35F + 0.15F * std::abs(quad.normal().x());
        cover[from + i] += 1.0F / kHallSamples;
        grey[from + i] += quad.grey * light / kHallSamples;
      }
    }
  }
}

}  // namespace weft::agents::sim
