#include "tests/bench/clouds/read_cloud.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace weft::clouds {
namespace {

constexpr std::size_t kFloat = sizeof(float);

/// Returns what follows `key` in `text`; empty if it is not there.
std::string after(const std::string& text, const std::string& key) {
  const std::size_t at = text.find(key);
  return at == std::string::npos ? "" : text.substr(at + key.size());
}

std::size_t count_after(const std::string& text, const std::string& key) {
  std::size_t count = 0;
  std::istringstream(after(text, key)) >> count;
  return count;
}

float float_at(const std::string& bytes, std::size_t at) {
  float value = 0.0F;
  if (at + kFloat <= bytes.size()) std::memcpy(&value, bytes.data() + at, kFloat);
  return value;
}

void add(Cloud& cloud, const Eigen::Vector3f& point) {
  if (point.allFinite()) cloud.points.push_back(point);
}

Cloud from_vtk(const std::string& text) {
  std::istringstream in(after(text, "\nPOINTS "));
  std::size_t count = 0;
  std::string type;
  in >> count >> type;
  Cloud cloud;
  for (Eigen::Vector3f point; count > 0 && in >> point.x() >> point.y() >> point.z(); --count) add(cloud, point);
  return cloud;
}

Cloud from_ply(const std::string& text) {
  const std::string data = after(text, "end_header\n");
  Cloud cloud;
  for (std::size_t at = 0; at < count_after(text, "element vertex "); ++at) {
    const std::size_t vertex = at * 4 * kFloat;
    add(cloud, {float_at(data, vertex), float_at(data, vertex + kFloat), float_at(data, vertex + 2 * kFloat)});
  }
  return cloud;
}

/// Unpacks LZF: a byte below 32 announces that many literals and one; another one a copy, of its upper three bits and
/// two (7: and a further byte), from its lower five bits and the next byte back.
std::string unpacked_lzf(const std::string& packed) {
  std::string out;
  std::size_t at = 0;
  const auto next = [&] { return at < packed.size() ? static_cast<std::uint8_t>(packed[at++]) : std::uint8_t{0}; };
  while (at < packed.size()) {
    const std::size_t control = next();
    if (control < 32) {
      for (std::size_t left = control + 1; left > 0; --left) out.push_back(static_cast<char>(next()));
      continue;
    }
    std::size_t length = (control >> 5U) + 2;
    if (length == 9) length += next();
    const std::size_t back = ((control & 31U) << 8U) + next() + 1;
    if (back > out.size()) return {};
    for (; length > 0; --length) out.push_back(out[out.size() - back]);
  }
  return out;
}

/// Reads a compressed PCD: all x, then all y, then all z.
Cloud from_pcd(const std::string& text) {
  const std::string data = after(text, "DATA binary_compressed\n");
  std::uint32_t packed_size = 0;
  if (data.size() > 8) std::memcpy(&packed_size, data.data(), sizeof(packed_size));
  const std::string planes = unpacked_lzf(data.size() > 8 ? data.substr(8, packed_size) : "");
  const std::size_t count = count_after(text, "\nPOINTS ");
  Cloud cloud;
  for (std::size_t at = 0; at < count; ++at) {
    add(cloud, {float_at(planes, kFloat * at), float_at(planes, kFloat * (count + at)),
                float_at(planes, kFloat * (2 * count + at))});
  }
  return cloud;
}

}  // namespace

Result<Cloud> read_cloud(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return fail(ErrorCode::not_found, file.string() + " cannot be read");
  Cloud cloud;
  if (file.extension() == ".vtk") cloud = from_vtk(text);
  if (file.extension() == ".ply") cloud = from_ply(text);
  if (file.extension() == ".pcd") cloud = from_pcd(text);
  if (cloud.points.empty()) return fail(ErrorCode::invalid, file.string() + " is no cloud of the kinds read here");
  return cloud;
}

}  // namespace weft::clouds
