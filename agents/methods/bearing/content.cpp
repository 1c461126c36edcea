#include "agents/methods/bearing/content.hpp"

#include <algorithm>
#include <cmath>

#include "agents/methods/content_bytes.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t magic = 0x45424C57U;  // "WLBE", little-endian
constexpr double grain_px = 0.125;

std::int16_t grains(float pixels) {
  return static_cast<std::int16_t>(
      std::lround(std::clamp(static_cast<double>(pixels) / grain_px, -32767.0, 32767.0)));
}

Sightings sightings_from(ContentReader& in) {
  Sightings sightings;
  sightings.could = in.number<std::uint8_t>("feature.could");
  if (sightings.could == 0) in.fault("feature.could", "is zero");
  sightings.seen = in.number<std::uint8_t>("feature.seen");
  if (sightings.seen > sightings.could) in.fault("feature.seen", "exceeds feature.could");
  return sightings;
}

}  // namespace

std::vector<Sightings> sightings_of(const BearingContent& content) {
  return content.sightings.empty() ? std::vector<Sightings>(content.features.size()) : content.sightings;
}

Bytes encode_bearing_content(const BearingContent& content) {
  ContentWriter out;
  out.number(magic);
  const bool is_learned = !content.sightings.empty();
  const bool is_brief = content.description == Description::brief;
  out.number((is_learned ? bearing_learned_format : bearing_content_format) + (is_brief ? brief_after : 0U));
  out.number(content.focal_px);
  out.number(content.driving.linear_m_s);
  out.number(content.driving.angular_rad_s);
  out.number(static_cast<std::uint16_t>(content.features.size()));
  for (std::size_t i = 0; i < content.features.size(); ++i) {
    const UprightFeature& feature = content.features[i];
    out.number(grains(feature.pixel.x()));
    out.number(grains(feature.pixel.y()));
    for (const std::uint64_t word : feature.descriptor) out.number(word);
    if (!is_learned) continue;
    out.number(content.sightings[i].could);
    out.number(content.sightings[i].seen);
  }
  return out.take();
}

Result<BearingContent> decode_bearing_content(ByteView bytes) {
  ContentReader in(bytes, "bearing content");
  if (in.number<std::uint32_t>("magic") != magic) in.fault("magic", "is not that of a bearing content");
  auto format = in.number<std::uint32_t>("format");
  constexpr std::uint32_t newest = bearing_learned_format + brief_after;
  if (!in.faulty() && format > newest)
    return fail(ErrorCode::newer, "bearing content: format " + std::to_string(format) + " is newer than " +
                                      std::to_string(newest) + "; update this program");
  BearingContent content;
  if (format > brief_after) {
    content.description = Description::brief;
    format -= brief_after;
  }
  const bool is_learned = format == bearing_learned_format;
  if (!is_learned && format != bearing_content_format) in.fault("format", "is unknown");
  content.focal_px = in.real("focal_px", 10.0, 1e4);
  content.driving.linear_m_s = in.real("driving.linear", -10.0, 10.0);
  content.driving.angular_rad_s = in.real("driving.angular", -20.0, 20.0);
  const auto count = in.number<std::uint16_t>("features.count");
  if (count > most_bearing_features) in.fault("features.count", "exceeds 4096");
  if (is_learned && count == 0) in.fault("features.count", "is zero of a learned content");
  for (std::size_t i = 0; i < count && !in.faulty(); ++i) {
    UprightFeature feature;
    feature.pixel.x() = static_cast<float>(grain_px * in.number<std::int16_t>("feature.x"));
    feature.pixel.y() = static_cast<float>(grain_px * in.number<std::int16_t>("feature.y"));
    for (std::uint64_t& word : feature.descriptor) word = in.number<std::uint64_t>("feature.descriptor");
    content.features.push_back(feature);
    if (is_learned) content.sightings.push_back(sightings_from(in));
  }
  if (!in.faulty() && !in.at_end()) in.fault("end", "is followed by more bytes");
  if (in.faulty()) return fail(ErrorCode::corrupt, in.message());
  return content;
}

}  // namespace weft::agents
