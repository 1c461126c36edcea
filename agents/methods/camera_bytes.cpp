#include "agents/methods/camera_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t longest_camera_id = 64;
constexpr std::uint16_t equidistant_bit = 0x8000U;  // of the width
constexpr std::uint16_t rational_bit = 0x4000U;
constexpr double largest_coefficient = 1e6;

std::uint16_t bit_of(LensModel lens) {
  if (lens == LensModel::radtan) return 0;
  return lens == LensModel::equidistant ? equidistant_bit : rational_bit;
}

LensModel lens_in(std::uint16_t width) {
  if ((width & equidistant_bit) != 0) return LensModel::equidistant;
  return (width & rational_bit) != 0 ? LensModel::rational : LensModel::radtan;
}

}  // namespace

void write_camera(ContentWriter& out, const CameraModel& camera) {
  const std::size_t length = std::min(camera.id.size(), longest_camera_id);
  out.number(static_cast<std::uint8_t>(length));
  out.raw({reinterpret_cast<const std::uint8_t*>(camera.id.data()), length});
  out.number(static_cast<std::uint16_t>(camera.width | bit_of(camera.lens)));
  out.number(static_cast<std::uint16_t>(camera.height));
  for (const double v : {camera.fx, camera.fy, camera.cx, camera.cy}) out.number(v);
  for (const double v : camera.distortion) out.number(v);
  if (camera.lens == LensModel::rational)
    for (const double v : camera.divisor) out.number(v);
  const Eigen::Quaterniond& q = camera.robot_from_camera.rotation;
  for (const double v : {q.w(), q.x(), q.y(), q.z()}) out.number(v);
  for (const double v : camera.robot_from_camera.translation) out.number(v);
}

CameraModel read_camera(ContentReader& in) {
  CameraModel camera;
  const auto length = in.number<std::uint8_t>("camera.id length");
  if (length > longest_camera_id) in.fault("camera.id length", "exceeds 64");
  const ByteView id = in.raw("camera.id", length);
  camera.id.assign(id.begin(), id.end());
  const auto width = in.number<std::uint16_t>("camera.width");
  camera.lens = lens_in(width);
  camera.width = width & ~bit_of(camera.lens);
  camera.height = in.number<std::uint16_t>("camera.height");
  for (double* v : {&camera.fx, &camera.fy, &camera.cx, &camera.cy}) *v = in.real("camera.intrinsics", 0.0, 1e5);
  for (double& v : camera.distortion) v = in.real("camera.distortion", -largest_coefficient, largest_coefficient);
  if (camera.lens == LensModel::rational)
    for (double& v : camera.divisor) v = in.real("camera.divisor", -largest_coefficient, largest_coefficient);
  Eigen::Quaterniond& q = camera.robot_from_camera.rotation;
  for (double* v : {&q.w(), &q.x(), &q.y(), &q.z()}) *v = in.real("camera.mount.rotation", -1.0, 1.0);
  if (std::abs(q.norm() - 1.0) > 1e-9) in.fault("camera.mount.rotation", "is not a unit quaternion");
  for (double& v : camera.robot_from_camera.translation) v = in.real("camera.mount.translation", -100.0, 100.0);
  if (const Result<void> sound = check(camera); !in.faulty() && !sound) in.fault("camera", sound.error().message);
  return camera;
}

void write_patch(ContentWriter& out, const PlanePatch& patch) {
  out.number(static_cast<std::uint16_t>(patch.width));
  out.number(static_cast<std::uint16_t>(patch.height));
  out.number(patch.metres_per_pixel);
  out.number(patch.first_pixel_on_plane.x());
  out.number(patch.first_pixel_on_plane.y());
  out.raw(patch.pixels);
}

PlanePatch read_patch(ContentReader& in, int widest_px) {
  const std::string exceeds = "exceeds " + std::to_string(widest_px);
  PlanePatch patch;
  patch.width = in.number<std::uint16_t>("patch.width");
  if (patch.width > widest_px) in.fault("patch.width", exceeds);
  patch.height = in.number<std::uint16_t>("patch.height");
  if (patch.height > widest_px) in.fault("patch.height", exceeds);
  patch.metres_per_pixel = in.real("patch.metres_per_pixel", 1e-4, 1.0);
  for (double& v : patch.first_pixel_on_plane) v = in.real("patch.first_pixel", -100.0, 100.0);
  const auto size = static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height);
  const ByteView pixels = in.raw("patch.pixels", size);
  patch.pixels.assign(pixels.begin(), pixels.end());
  return patch;
}

}  // namespace weft::agents
