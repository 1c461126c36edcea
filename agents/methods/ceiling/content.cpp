#include "agents/methods/ceiling/content.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "agents/methods/camera_bytes.hpp"
#include "agents/methods/content_bytes.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t magic = 0x4C43'4C57U;  // "WLCL", little-endian
constexpr double grain_m = 1e-3;               // of a feature's place and height: a twentieth of a pixel
constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double widest_attitude = 0.5;

std::int16_t signed_grains(double metres) {
  return static_cast<std::int16_t>(std::lround(std::clamp(metres / grain_m, -32767.0, 32767.0)));
}

std::uint16_t grains(double metres) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(metres / grain_m, 0.0, 65535.0)));
}

void write_feature(ContentWriter& out, const PlaneFeature& f) {
  out.number(signed_grains(f.on_plane.x()));
  out.number(signed_grains(f.on_plane.y()));
  const double share = f.heading_rad / full_turn - std::floor(f.heading_rad / full_turn);
  out.number(static_cast<std::uint8_t>(std::lround(share * 256.0) & 255));
  out.number(grains(f.above_floor_m));
  out.number(grains(f.above_floor_sigma_m));
  for (const std::uint64_t word : f.descriptor) out.number(word);
}

PlaneFeature read_feature(ContentReader& in, double lowest_m) {
  PlaneFeature f;
  f.on_plane.x() = grain_m * in.number<std::int16_t>("feature.x");
  f.on_plane.y() = grain_m * in.number<std::int16_t>("feature.y");
  f.heading_rad = wrap_angle(full_turn / 256.0 * in.number<std::uint8_t>("feature.heading"));
  f.above_floor_m = grain_m * in.number<std::uint16_t>("feature.height");
  if (!in.faulty() && f.above_floor_m <= lowest_m) in.fault("feature.height", "is not above the camera");
  f.above_floor_sigma_m = grain_m * in.number<std::uint16_t>("feature.height_sigma");
  for (std::uint64_t& word : f.descriptor) word = in.number<std::uint64_t>("feature.descriptor");
  return f;
}

}  // namespace

Bytes encode_ceiling_content(const CeilingContent& content) {
  ContentWriter out;
  out.number(magic);
  out.number(ceiling_content_format);
  write_camera(out, content.camera);
  for (const double v : content.attitude.vector()) out.number(v);
  for (const double v : content.attitude_sigma) out.number(v);
  out.number(content.ceiling_m);
  out.number(content.ceiling_sigma_m);
  out.number(static_cast<std::uint16_t>(content.features.size()));
  for (const PlaneFeature& f : content.features) write_feature(out, f);
  write_patch(out, content.patch);
  return out.take();
}

Result<CeilingContent> decode_ceiling_content(ByteView bytes) {
  ContentReader in(bytes, "ceiling content");
  if (in.number<std::uint32_t>("magic") != magic) in.fault("magic", "is not that of a ceiling content");
  const auto format = in.number<std::uint32_t>("format");
  if (!in.faulty() && format > ceiling_content_format)
    return fail(ErrorCode::newer, "ceiling content: format " + std::to_string(format) + " is newer than " +
                                      std::to_string(ceiling_content_format) + "; update this program");
  if (format != ceiling_content_format) in.fault("format", "is unknown");
  if (bytes.size() > largest_ceiling_content) in.fault("size", "makes it exceed 16384 bytes");
  CeilingContent content;
  content.camera = read_camera(in);
  Eigen::Vector3d attitude;
  for (double& v : attitude) v = in.real("attitude", -widest_attitude, widest_attitude);
  content.attitude = Attitude::from(attitude);
  for (double& v : content.attitude_sigma) v = in.real("attitude_sigma", 1e-6, widest_attitude);
  const double camera_m = content.camera.robot_from_camera.translation.z();
  content.ceiling_m = in.real("ceiling", 0.0, 60.0);
  if (!in.faulty() && content.ceiling_m <= camera_m) in.fault("ceiling", "is not above the camera");
  content.ceiling_sigma_m = in.real("ceiling_sigma", 1e-6, 60.0);
  const auto count = in.number<std::uint16_t>("features.count");
  if (count > most_ceiling_features) in.fault("features.count", "exceeds 300");
  for (std::size_t i = 0; i < count && !in.faulty(); ++i) content.features.push_back(read_feature(in, camera_m));
  content.patch = read_patch(in, widest_ceiling_patch_px);
  if (!in.faulty() && !in.at_end()) in.fault("end", "is followed by more bytes");
  if (in.faulty()) return fail(ErrorCode::corrupt, in.message());
  return content;
}

}  // namespace weft::agents
