#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/network/change.hpp"
#include "storage/clouds/cloud.hpp"
#include "storage/clouds/head.hpp"
#include "storage/clouds/morton.hpp"
#include "storage/clouds/radix_sort.hpp"

namespace weft::clouds {
namespace {

static_assert(std::endian::native == std::endian::little);  // codes are copied as they stand in memory

constexpr double kMicrometres = 1e-6;
constexpr const char* kAxes = "xyz";

using LatticePoint = std::array<std::int32_t, 3>;

struct Lattice {
  std::vector<LatticePoint> points;
  LatticePoint least{};
  LatticePoint most{};
};

Error invalid(const std::string& what) {
  return {ErrorCode::invalid, "cloud: " + what};
}

std::string quantum_text(std::uint32_t quantum_um) {
  return "with a quantum of " + std::to_string(quantum_um) + " um";
}

Result<void> check_sizes(const Cloud& cloud, std::uint32_t quantum_um) {
  if (quantum_um < 1 || quantum_um > kLargestQuantum_um) {
    return fail(invalid("quantum is " + std::to_string(quantum_um) + " um, must be in [1, " +
                        std::to_string(kLargestQuantum_um) + "]"));
  }
  if (!cloud.values.empty() && cloud.values.size() != cloud.points.size()) {
    return fail(invalid(std::to_string(cloud.values.size()) + " values for " + std::to_string(cloud.points.size()) +
                        " points, must be one a point or none"));
  }
  return {};
}

Result<void> check_fits(const Cloud& cloud, std::uint8_t value_bytes) {
  const std::size_t room = kLargestContent - kMagicBytes - kHeadBytes;
  if (cloud.attached.size() > room) {
    return fail(ErrorCode::exhausted, "cloud: " + std::to_string(cloud.attached.size()) +
                                          " bytes are attached, a content holds at most " + std::to_string(room));
  }
  const std::size_t most = (room - cloud.attached.size()) / (sizeof(std::uint64_t) + value_bytes);
  if (cloud.points.size() <= most) return {};
  return fail(ErrorCode::exhausted, "cloud: " + std::to_string(cloud.points.size()) +
                                        " points, a content holds at most " + std::to_string(most) +
                                        " beside what is attached; thin the cloud or cut it");
}

double quanta_per_metre(std::uint32_t quantum_um) {
  return 1.0 / (quantum_um * kMicrometres);
}

/// Returns whether the number is within the lattice; false for what is not finite.
bool is_on_lattice(double quanta) {
  return std::abs(quanta) <= kLatticeBound - 1;
}

/// Returns an error that names the first coordinate that has no place on the lattice.
Error name_bad_coordinate(const Cloud& cloud, std::uint32_t quantum_um) {
  for (std::size_t at = 0; at < cloud.points.size(); ++at) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const auto x = static_cast<double>(cloud.points[at][axis]);
      if (is_on_lattice(x * quanta_per_metre(quantum_um))) continue;
      const std::string which = "point " + std::to_string(at) + ": " + kAxes[axis] + " is " + std::to_string(x);
      if (!std::isfinite(x)) return invalid(which + ", must be finite");
      return invalid(which + " m, " + quantum_text(quantum_um) + " at most " +
                     std::to_string((kLatticeBound - 1) * (quantum_um * kMicrometres)) +
                     " m from zero; take a larger quantum or another origin");
    }
  }
  return {ErrorCode::internal, "cloud: a coordinate is off the lattice, none was found"};
}

Result<Lattice> to_lattice(const Cloud& cloud, std::uint32_t quantum_um) {
  constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
  Lattice lattice{std::vector<LatticePoint>(cloud.points.size()), {kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  const double scale = quanta_per_metre(quantum_um);
  bool all_fit = true;
  for (std::size_t at = 0; at < cloud.points.size(); ++at) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double quanta = static_cast<double>(cloud.points[at][axis]) * scale;
      const bool fits = is_on_lattice(quanta);
      all_fit = all_fit && fits;
      const auto value = static_cast<std::int32_t>(fits ? quanta + std::copysign(0.5, quanta) : 0.0);
      lattice.points[at][axis] = value;
      lattice.least[axis] = std::min(lattice.least[axis], value);
      lattice.most[axis] = std::max(lattice.most[axis], value);
    }
  }
  if (!all_fit) return fail(name_bad_coordinate(cloud, quantum_um));
  if (cloud.points.empty()) lattice.least = lattice.most = {};
  return lattice;
}

Result<void> check_extent(const Lattice& lattice, std::uint32_t quantum_um) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const std::int32_t extent = lattice.most[axis] - lattice.least[axis];
    if (extent < std::int32_t{1} << kAxisBits) continue;
    return fail(invalid(std::string("it spans ") + std::to_string(extent * (quantum_um * kMicrometres)) + " m in " +
                        kAxes[axis] + ", " + quantum_text(quantum_um) + " at most " +
                        std::to_string((1U << kAxisBits) * (quantum_um * kMicrometres)) +
                        " m; take a larger quantum or cut the cloud"));
  }
  return {};
}

std::uint64_t code_of_point(const Lattice& lattice, std::size_t at) {
  std::array<std::uint32_t, 3> cell{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    cell[axis] = static_cast<std::uint32_t>(lattice.points[at][axis] - lattice.least[axis]);
  }
  return code_from_cell(cell);
}

Bytes points_alone(const Lattice& lattice, const Head& head) {
  std::vector<std::uint64_t> codes(head.count);
  for (std::size_t at = 0; at < codes.size(); ++at) codes[at] = code_of_point(lattice, at);
  radix_sort(codes, [](std::uint64_t code) { return code; });
  Bytes bytes = with_head(head);
  std::memcpy(bytes.data() + kMagicBytes + kHeadBytes, codes.data(), codes.size() * sizeof(std::uint64_t));
  return bytes;
}

struct Valued {
  std::uint64_t code = 0;
  std::uint16_t value = 0;
};

/// Returns the points with their values, sorted by (code, value).
std::vector<Valued> sorted_with_values(const Lattice& lattice, const std::vector<std::uint16_t>& values) {
  std::vector<Valued> entries(values.size());
  for (std::size_t at = 0; at < entries.size(); ++at) entries[at] = {code_of_point(lattice, at), values[at]};
  radix_sort(entries, [](const Valued& entry) { return std::uint64_t{entry.value}; });
  radix_sort(entries, [](const Valued& entry) { return entry.code; });  // stable: keeps the order of values
  return entries;
}

Bytes points_with_values(const Lattice& lattice, const std::vector<std::uint16_t>& values, const Head& head) {
  const std::vector<Valued> entries = sorted_with_values(lattice, values);
  Bytes bytes = with_head(head);
  std::uint8_t* code_at = bytes.data() + kMagicBytes + kHeadBytes;
  std::uint8_t* value_at = code_at + entries.size() * sizeof(std::uint64_t);
  for (const Valued& entry : entries) {
    std::memcpy(code_at, &entry.code, sizeof(entry.code));
    std::memcpy(value_at, &entry.value, head.value_bytes);
    code_at += sizeof(entry.code);
    value_at += head.value_bytes;
  }
  return bytes;
}

std::uint8_t value_bytes(const std::vector<std::uint16_t>& values) {
  if (values.empty()) return 0;
  return *std::max_element(values.begin(), values.end()) > 0xff ? 2 : 1;
}

}  // namespace

Result<Bytes> canonical_bytes(const Cloud& cloud, std::uint32_t quantum_um) {
  if (auto sizes = check_sizes(cloud, quantum_um); !sizes) return fail(sizes.error());
  const std::uint8_t bytes_a_value = value_bytes(cloud.values);
  if (auto fits = check_fits(cloud, bytes_a_value); !fits) return fail(fits.error());
  const auto lattice = to_lattice(cloud, quantum_um);
  if (!lattice) return fail(lattice.error());
  if (auto extent = check_extent(*lattice, quantum_um); !extent) return fail(extent.error());
  const Head head{quantum_um, lattice->least, bytes_a_value, static_cast<std::uint32_t>(cloud.points.size()),
                  static_cast<std::uint32_t>(cloud.attached.size())};
  Bytes bytes = bytes_a_value == 0 ? points_alone(*lattice, head) : points_with_values(*lattice, cloud.values, head);
  std::copy(cloud.attached.begin(), cloud.attached.end(), bytes.end() - head.attached);
  return bytes;
}

}  // namespace weft::clouds
