#include "agents/methods/topometric/content.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "agents/methods/content_bytes.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t topometric_magic = 0x4D54'4C57U;  // "WLTM", little-endian
constexpr double feature_grain_m = 1e-3;
constexpr double farthest_point_m = 100.0;
constexpr double farthest_pose_m = 1000.0;
constexpr std::size_t most_stored_frames = 32;

void write_pose(ContentWriter& out, const Pose3& pose) {
  const Eigen::Quaterniond& q = pose.rotation;
  for (const double v : {q.w(), q.x(), q.y(), q.z()}) out.number(v);
  for (const double v : pose.translation) out.number(v);
}

Pose3 read_pose(ContentReader& in, const std::string& field) {
  Pose3 pose;
  Eigen::Quaterniond& q = pose.rotation;
  for (double* v : {&q.w(), &q.x(), &q.y(), &q.z()}) *v = in.real(field + ".rotation", -1.0, 1.0);
  if (std::abs(q.norm() - 1.0) > 1e-9) in.fault(field + ".rotation", "is not a unit quaternion");
  for (double& v : pose.translation) v = in.real(field + ".translation", -farthest_pose_m, farthest_pose_m);
  return pose;
}

void write_rig(ContentWriter& out, const StereoRig& rig) {
  out.number(static_cast<std::uint16_t>(rig.width));
  out.number(static_cast<std::uint16_t>(rig.height));
  for (const double v : {rig.focal_px, rig.cx, rig.cy, rig.baseline_m}) out.number(v);
  write_pose(out, rig.robot_from_camera);
}

StereoRig read_rig(ContentReader& in) {
  constexpr int least_px = 16;
  constexpr int most_px = 16384;
  StereoRig rig;
  for (int* size : {&rig.width, &rig.height}) {
    *size = in.number<std::uint16_t>("rig.size");
    if (*size < least_px || *size > most_px) in.fault("rig.size", "is out of bounds");
  }
  rig.focal_px = in.real("rig.focal_px", 1.0, 1e5);
  for (double* v : {&rig.cx, &rig.cy}) *v = in.real("rig.centre", -1e5, 1e5);
  rig.baseline_m = in.real("rig.baseline_m", 1e-3, 10.0);
  rig.robot_from_camera = read_pose(in, "rig.robot_from_camera");
  return rig;
}

std::int16_t feature_grains(float metres) {
  const double grains = static_cast<double>(metres) / feature_grain_m;
  return static_cast<std::int16_t>(std::lround(std::clamp(grains, -32767.0, 32767.0)));
}

void write_feature(ContentWriter& out, const SpaceFeature& feature) {
  for (const float v : feature.in_place) out.number(feature_grains(v));
  const double sigma = static_cast<double>(feature.depth_sigma_m) / feature_grain_m;
  out.number(static_cast<std::uint16_t>(std::lround(std::clamp(sigma, 0.0, 65535.0))));
  for (const std::uint64_t word : feature.descriptor) out.number(word);
}

SpaceFeature read_feature(ContentReader& in) {
  SpaceFeature feature;
  for (float& v : feature.in_place)
    v = static_cast<float>(feature_grain_m * in.number<std::int16_t>("feature.position"));
  feature.depth_sigma_m = static_cast<float>(feature_grain_m * in.number<std::uint16_t>("feature.depth_sigma"));
  for (std::uint64_t& word : feature.descriptor) word = in.number<std::uint64_t>("feature.descriptor");
  return feature;
}

Bytes attached_to(const TopometricContent& content) {
  ContentWriter out;
  out.number(topometric_magic);
  out.number(topometric_content_format);
  write_rig(out, content.rig);
  write_pose(out, content.floor.level_from_odometry);
  out.number(content.floor.points);
  out.number(content.clear_m);
  out.number(static_cast<std::uint16_t>(content.cloud.place_from_frames.size()));
  for (std::size_t i = 0; i < content.cloud.place_from_frames.size(); ++i) {
    write_pose(out, content.cloud.place_from_frames[i]);
    for (const float v : content.cloud.cameras[i]) out.number(v);
    out.number(i < content.cloud.clear_bearings.size() ? content.cloud.clear_bearings[i] : std::uint64_t{0});
  }
  out.number(static_cast<std::uint16_t>(content.features.size()));
  for (const SpaceFeature& feature : content.features) write_feature(out, feature);
  return out.take();
}

void read_frames(ContentReader& in, PlaceCloud& cloud) {
  const auto count = in.number<std::uint16_t>("frames.count");
  if (count > most_stored_frames) in.fault("frames.count", "exceeds 32");
  for (std::size_t i = 0; i < count && !in.faulty(); ++i) {
    cloud.place_from_frames.push_back(read_pose(in, "frame"));
    Eigen::Vector3f camera;
    for (float& v : camera) {
      v = in.number<float>("frame.camera");
      if (!(std::abs(static_cast<double>(v)) <= farthest_pose_m)) in.fault("frame.camera", "is out of bounds");
    }
    cloud.cameras.push_back(camera);
    cloud.clear_bearings.push_back(in.number<std::uint64_t>("frame.clear_bearings"));
  }
}

/// Returns what of the points themselves a reader must not believe; empty: nothing.
std::string wrong_in(const clouds::Cloud& cloud, std::size_t frames) {
  if (!cloud.points.empty() && cloud.values.size() != cloud.points.size()) return "has points without frames";
  const auto is_far = [](const Eigen::Vector3f& p) {
    return static_cast<double>(p.cwiseAbs().maxCoeff()) > farthest_point_m;
  };
  const auto far = std::find_if(cloud.points.begin(), cloud.points.end(), is_far);
  if (far != cloud.points.end())
    return "has point " + std::to_string(far - cloud.points.begin()) + " beyond 100 m on an axis";
  const auto none =
      std::find_if(cloud.values.begin(), cloud.values.end(), [&](std::uint16_t frame) { return frame >= frames; });
  if (none != cloud.values.end())
    return "has point " + std::to_string(none - cloud.values.begin()) + " of frame " + std::to_string(*none) +
           ", and " + std::to_string(frames) + " frames";
  return {};
}

}  // namespace

Bytes encode_topometric_content(const TopometricContent& content) {
  const clouds::Cloud cloud{content.cloud.points, content.cloud.frames, attached_to(content)};
  return clouds::canonical_bytes(cloud, cloud_quantum_um).value_or(Bytes{});
}

Result<TopometricContent> decode_topometric_content(ByteView bytes) {
  Result<clouds::LatticeCloud> lattice = clouds::decode_cloud(bytes);
  if (!lattice) return fail(lattice.error().code, "topometric content: " + lattice.error().message);
  const auto corrupt = [](const std::string& what) {
    return fail(ErrorCode::corrupt, "topometric content: " + what + "; fetch the content again");
  };
  if (lattice->quantum_um != cloud_quantum_um)
    return corrupt("cloud.quantum at offset 8 is " + std::to_string(lattice->quantum_um) + " um, must be 5000");
  ContentReader in(bytes, "topometric content");
  in.raw("cloud", bytes.size() - lattice->cloud.attached.size());
  if (in.number<std::uint32_t>("magic") != topometric_magic) in.fault("magic", "is not that of a topometric content");
  const auto format = in.number<std::uint32_t>("format");
  if (!in.faulty() && format > topometric_content_format)
    return fail(ErrorCode::newer, "topometric content: format " + std::to_string(format) + " is newer than " +
                                      std::to_string(topometric_content_format) + "; update this program");
  if (format != topometric_content_format) in.fault("format", "is unknown");
  TopometricContent content;
  content.rig = read_rig(in);
  content.floor.level_from_odometry = read_pose(in, "floor.level_from_odometry");
  content.floor.points = in.number<std::uint32_t>("floor.points");
  content.clear_m = in.number<float>("clear_m");
  if (!(content.clear_m >= 0.0F && static_cast<double>(content.clear_m) <= farthest_point_m))
    in.fault("clear_m", "is out of bounds");
  read_frames(in, content.cloud);
  const auto features = in.number<std::uint16_t>("features.count");
  if (features > most_space_features) in.fault("features.count", "exceeds 300");
  for (std::size_t i = 0; i < features && !in.faulty(); ++i) content.features.push_back(read_feature(in));
  if (!in.faulty() && !in.at_end()) in.fault("end", "is followed by more bytes");
  if (in.faulty()) return fail(ErrorCode::corrupt, in.message());
  if (const std::string wrong = wrong_in(lattice->cloud, content.cloud.cameras.size()); !wrong.empty())
    return corrupt("cloud.points at offset 33 " + wrong);
  content.cloud.points = std::move(lattice->cloud.points);
  content.cloud.frames = std::move(lattice->cloud.values);
  return content;
}

}  // namespace weft::agents
