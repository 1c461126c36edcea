#include "agents/methods/floor/content.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "agents/methods/content_bytes.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t magic = 0x52464C57U;  // "WLFR", little-endian
constexpr std::size_t longest_camera_id = 64;
constexpr std::uint16_t equidistant_bit = 0x8000U;  // of the width
constexpr std::uint16_t rational_bit = 0x4000U;
constexpr double largest_coefficient = 1e6;
constexpr double grain_m = 1e-4;
constexpr double full_turn = 2.0 * std::numbers::pi;

std::int16_t grains(double metres) {
  return static_cast<std::int16_t>(std::lround(std::clamp(metres / grain_m, -32767.0, 32767.0)));
}

std::uint16_t bit_of(LensModel lens) {
  if (lens == LensModel::radtan) return 0;
  return lens == LensModel::equidistant ? equidistant_bit : rational_bit;
}

LensModel lens_in(std::uint16_t width) {
  if ((width & equidistant_bit) != 0) return LensModel::equidistant;
  return (width & rational_bit) != 0 ? LensModel::rational : LensModel::radtan;
}

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

void write_features(ContentWriter& out, const std::vector<PlaneFeature>& features) {
  out.number(static_cast<std::uint16_t>(features.size()));
  for (const PlaneFeature& f : features) {
    out.number(grains(f.on_plane.x()));
    out.number(grains(f.on_plane.y()));
    const double share = f.heading_rad / full_turn - std::floor(f.heading_rad / full_turn);
    out.number(static_cast<std::uint8_t>(std::lround(share * 256.0) & 255));
    for (const std::uint64_t word : f.descriptor) out.number(word);
  }
}

std::vector<PlaneFeature> read_features(ContentReader& in) {
  const auto count = in.number<std::uint16_t>("features.count");
  if (count > most_floor_features) in.fault("features.count", "exceeds 4096");
  std::vector<PlaneFeature> features;
  for (std::size_t i = 0; i < count && !in.faulty(); ++i) {
    PlaneFeature f;
    f.on_plane.x() = grain_m * in.number<std::int16_t>("feature.x");
    f.on_plane.y() = grain_m * in.number<std::int16_t>("feature.y");
    f.heading_rad = wrap_angle(full_turn / 256.0 * in.number<std::uint8_t>("feature.heading"));
    for (std::uint64_t& word : f.descriptor) word = in.number<std::uint64_t>("feature.descriptor");
    features.push_back(f);
  }
  return features;
}

void write_patch(ContentWriter& out, const PlanePatch& patch) {
  out.number(static_cast<std::uint16_t>(patch.width));
  out.number(static_cast<std::uint16_t>(patch.height));
  out.number(patch.metres_per_pixel);
  out.number(patch.first_pixel_on_plane.x());
  out.number(patch.first_pixel_on_plane.y());
  out.raw(patch.pixels);
}

PlanePatch read_patch(ContentReader& in) {
  PlanePatch patch;
  patch.width = in.number<std::uint16_t>("patch.width");
  if (patch.width > widest_floor_patch_px) in.fault("patch.width", "exceeds 512");
  patch.height = in.number<std::uint16_t>("patch.height");
  if (patch.height > widest_floor_patch_px) in.fault("patch.height", "exceeds 512");
  patch.metres_per_pixel = in.real("patch.metres_per_pixel", 1e-4, 1.0);
  for (double& v : patch.first_pixel_on_plane) v = in.real("patch.first_pixel", -100.0, 100.0);
  const auto size = static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height);
  const ByteView pixels = in.raw("patch.pixels", size);
  patch.pixels.assign(pixels.begin(), pixels.end());
  return patch;
}

}  // namespace

Bytes encode_floor_content(const FloorContent& content) {
  ContentWriter out;
  out.number(magic);
  out.number(floor_content_format);
  write_camera(out, content.camera);
  for (const double v : content.attitude.vector()) out.number(v);
  for (const double v : content.attitude_sigma) out.number(v);
  write_features(out, content.features);
  write_patch(out, content.patch);
  return out.take();
}

Result<FloorContent> decode_floor_content(ByteView bytes) {
  ContentReader in(bytes, "floor content");
  if (in.number<std::uint32_t>("magic") != magic) in.fault("magic", "is not that of a floor content");
  const auto format = in.number<std::uint32_t>("format");
  if (!in.faulty() && format > floor_content_format)
    return fail(ErrorCode::newer, "floor content: format " + std::to_string(format) + " is newer than " +
                                      std::to_string(floor_content_format) + "; update this program");
  if (format != floor_content_format) in.fault("format", "is unknown");
  FloorContent content;
  content.camera = read_camera(in);
  Eigen::Vector3d attitude;
  for (double& v : attitude) v = in.real("attitude", -0.2, 0.2);
  content.attitude = Attitude::from(attitude);
  for (double& v : content.attitude_sigma) v = in.real("attitude_sigma", 1e-6, 0.2);
  content.features = read_features(in);
  content.patch = read_patch(in);
  if (!in.faulty() && !in.at_end()) in.fault("end", "is followed by more bytes");
  if (in.faulty()) return fail(ErrorCode::corrupt, in.message());
  return content;
}

}  // namespace weft::agents
