#include "agents/methods/floor/content.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "agents/methods/camera_bytes.hpp"
#include "agents/methods/content_bytes.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t magic = 0x52464C57U;  // "WLFR", little-endian
constexpr double grain_m = 1e-4;
constexpr double full_turn = 2.0 * std::numbers::pi;

std::int16_t grains(double metres) {
  return static_cast<std::int16_t>(std::lround(std::clamp(metres / grain_m, -32767.0, 32767.0)));
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
  content.patch = read_patch(in, widest_floor_patch_px);
  if (!in.faulty() && !in.at_end()) in.fault("end", "is followed by more bytes");
  if (in.faulty()) return fail(ErrorCode::corrupt, in.message());
  return content;
}

}  // namespace weft::agents
