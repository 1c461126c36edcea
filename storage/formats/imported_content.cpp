#include <cmath>

#include "core/byte_reader.hpp"
#include "core/byte_writer.hpp"
#include "storage/formats/import.hpp"

namespace weft::formats {
namespace {
constexpr std::uint8_t kNoEstimate = 0;
constexpr std::uint8_t kPlanarEstimate = 1;
constexpr std::uint8_t kSpatialEstimate = 2;
}  // namespace

Bytes encode(const ImportedContent& content) {
  ByteWriter out;
  out.number(content.key);
  if (!content.estimate.has_value()) {
    out.number(kNoEstimate);
  } else if (const auto* const planar = std::get_if<Pose2>(&*content.estimate)) {
    out.number(kPlanarEstimate);
    for (const double value : {planar->x, planar->y, planar->heading}) out.f64(value);
  } else {
    const auto& pose = std::get<Pose3>(*content.estimate);
    out.number(kSpatialEstimate);
    for (const double value : pose.translation) out.f64(value);
    for (const double value : {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z()}) {
      out.f64(value);
    }
  }
  return out.take();
}

Result<ImportedContent> decode_imported_content(ByteView bytes) {
  ByteReader in(bytes);
  ImportedContent content;
  content.key = in.number<std::uint64_t>("key");
  const auto kind = in.ranged<std::uint8_t>("kind of estimate", kNoEstimate, kSpatialEstimate);
  const auto finite = [&in](const char* field) {
    const std::size_t at = in.offset();
    const double value = in.f64(field);
    if (!std::isfinite(value)) in.corrupt(field, at, "is not finite");
    return value;
  };
  if (kind == kPlanarEstimate) {
    Pose2 pose;
    pose.x = finite("x");
    pose.y = finite("y");
    pose.heading = finite("heading");
    content.estimate = pose;
  }
  if (kind == kSpatialEstimate) {
    Pose3 pose;
    for (double& value : pose.translation) value = finite("translation");
    const std::size_t at = in.offset();
    pose.rotation.w() = finite("rotation");
    pose.rotation.x() = finite("rotation");
    pose.rotation.y() = finite("rotation");
    pose.rotation.z() = finite("rotation");
    constexpr double kUnit = 1e-6;
    if (std::abs(pose.rotation.norm() - 1.0) > kUnit) in.corrupt("rotation", at, "is not unit");
    content.estimate = pose;
  }
  if (const Result<void> whole = in.finish("imported content"); !whole) return fail(whole.error());
  return content;
}

}  // namespace weft::formats
