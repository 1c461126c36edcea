
#include "core/byte_writer.hpp"
#include "storage/formats/cloud.hpp"
#include "storage/formats/lines.hpp"

namespace weft::formats {
namespace {

std::uint32_t packed(const std::array<std::uint8_t, 3>& colour) {
  return (std::uint32_t{colour[0]} << 16U) | (std::uint32_t{colour[1]} << 8U) | colour[2];
}

void add(ByteWriter& out, const std::string& text) {
  out.raw({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// Returns the floats of one point in the order of the header, without its colour.
std::vector<float> floats_of(const Cloud& cloud, std::size_t point) {
  std::vector<float> floats(cloud.points[point].begin(), cloud.points[point].end());
  if (!cloud.intensities.empty()) floats.push_back(cloud.intensities[point]);
  if (!cloud.normals.empty()) {
    floats.insert(floats.end(), cloud.normals[point].begin(), cloud.normals[point].end());
  }
  return floats;
}

/// Writes points as rows of text; the colour last, as words of the format.
template <class Colour>
void add_text(ByteWriter& out, const Cloud& cloud, Colour&& colour) {
  for (std::size_t point = 0; point < cloud.points.size(); ++point) {
    std::string row;
    for (const float value : floats_of(cloud, point)) row += (row.empty() ? "" : " ") + text_of(value);
    if (!cloud.colours.empty()) row += colour(cloud.colours[point]);
    add(out, row + "\n");
  }
}

template <class Colour>
void add_binary(ByteWriter& out, const Cloud& cloud, Colour&& colour) {
  for (std::size_t point = 0; point < cloud.points.size(); ++point) {
    for (const float value : floats_of(cloud, point)) out.f32(value);
    if (!cloud.colours.empty()) colour(cloud.colours[point]);
  }
}

std::string times(std::size_t count, const std::string& word) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += word;
  return text;
}

}  // namespace

Bytes pcd_bytes(const Cloud& cloud, CloudCoding coding) {
  std::string fields = " x y z";
  std::size_t floats = 3;
  if (!cloud.intensities.empty()) {
    fields += " intensity";
    ++floats;
  }
  if (!cloud.normals.empty()) {
    fields += " normal_x normal_y normal_z";
    floats += 3;
  }
  const bool coloured = !cloud.colours.empty();
  if (coloured) fields += " rgb";
  const Pose3& from = cloud.world_from_sensor;
  std::string header = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + fields + "\nSIZE" +
                       times(floats + (coloured ? 1 : 0), " 4") + "\nTYPE" + times(floats, " F") +
                       (coloured ? " U" : "") + "\nCOUNT" + times(floats + (coloured ? 1 : 0), " 1") + "\nWIDTH " +
                       std::to_string(cloud.width) + "\nHEIGHT " + std::to_string(cloud.height) + "\nVIEWPOINT";
  for (const double value : from.translation) header += " " + text_of(value);
  for (const double value : {from.rotation.w(), from.rotation.x(), from.rotation.y(), from.rotation.z()}) {
    header += " " + text_of(value);
  }
  header += "\nPOINTS " + std::to_string(cloud.points.size()) + "\nDATA ";
  ByteWriter out;
  add(out, header + (coding == CloudCoding::text ? "ascii\n" : "binary\n"));
  if (coding == CloudCoding::text) {
    add_text(out, cloud, [](const auto& colour) { return " " + std::to_string(packed(colour)); });
  } else {
    add_binary(out, cloud, [&out](const auto& colour) { out.number(packed(colour)); });
  }
  return out.take();
}

Bytes ply_bytes(const Cloud& cloud, CloudCoding coding) {
  std::string header = std::string("ply\nformat ") +
                       (coding == CloudCoding::text ? "ascii" : "binary_little_endian") + " 1.0\nelement vertex " +
                       std::to_string(cloud.points.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!cloud.intensities.empty()) header += "property float intensity\n";
  if (!cloud.normals.empty()) header += "property float nx\nproperty float ny\nproperty float nz\n";
  if (!cloud.colours.empty()) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  ByteWriter out;
  add(out, header + "end_header\n");
  if (coding == CloudCoding::text) {
    add_text(out, cloud, [](const auto& colour) {
      return " " + std::to_string(colour[0]) + " " + std::to_string(colour[1]) + " " + std::to_string(colour[2]);
    });
  } else {
    add_binary(out, cloud, [&out](const auto& colour) { out.raw(colour); });
  }
  return out.take();
}

}  // namespace weft::formats
