#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "storage/clouds/cloud.hpp"
#include "storage/clouds/head.hpp"
#include "storage/clouds/morton.hpp"

namespace weft::clouds {
namespace {

static_assert(std::endian::native == std::endian::little);  // codes are copied as they stand in memory

/// Holds the canonical bytes: the head, and what stands behind it, of the size that the head asks for.
struct Body {
  Head head;
  ByteView codes;
  ByteView values;
  ByteView attached;

  std::uint64_t code(std::size_t at) const {
    std::uint64_t value = 0;
    std::memcpy(&value, codes.data() + at * sizeof(value), sizeof(value));
    return value;
  }
  std::uint16_t value(std::size_t at) const {
    std::uint16_t number = 0;
    std::memcpy(&number, values.data() + at * head.value_bytes, head.value_bytes);
    return number;
  }
};

/// Holds the points, and the range of their distances from the origin on each axis, in quanta.
struct Placed {
  std::vector<Eigen::Vector3f> points;
  std::array<std::uint32_t, 3> least{~0U, ~0U, ~0U};
  std::array<std::uint32_t, 3> most{};
};

Placed place_points(const Body& body) {
  Placed placed{std::vector<Eigen::Vector3f>(body.head.count)};
  const double metres_per_quantum = body.head.quantum_um * 1e-6;
  for (std::size_t at = 0; at < placed.points.size(); ++at) {
    const auto cell = cell_from_code(body.code(at));
    for (unsigned axis = 0; axis < 3; ++axis) {
      placed.least[axis] = std::min(placed.least[axis], cell[axis]);
      placed.most[axis] = std::max(placed.most[axis], cell[axis]);
      const std::int32_t quanta = body.head.origin[axis] + static_cast<std::int32_t>(cell[axis]);
      placed.points[at][axis] = static_cast<float>(quanta * metres_per_quantum);
    }
  }
  return placed;
}

/// Checks that codes never fall, nor do the values of equal codes.
Result<void> check_order(const Body& body) {
  std::uint64_t before = 0;
  for (std::size_t at = 0; at < body.head.count; ++at) {
    const std::uint64_t code = body.code(at);
    if (code < before) return corrupt_cloud("point " + std::to_string(at) + " is out of order");
    if (at > 0 && code == before && body.head.value_bytes > 0 && body.value(at) < body.value(at - 1)) {
      return corrupt_cloud("value " + std::to_string(at) + " is out of order");
    }
    before = code;
  }
  if (before >> 63U != 0) return corrupt_cloud("its last code is 2^63 or more");
  return {};
}

/// Checks that the origin is the least coordinate on each axis, and that no point lies off the lattice.
Result<void> check_bounds(const Head& head, const Placed& placed) {
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto origin = static_cast<std::int64_t>(head.origin[axis]);
    if (head.count == 0 ? origin != 0 : placed.least[axis] != 0) {
      return corrupt_cloud("its origin is not its least coordinate");
    }
    if (origin + placed.most[axis] >= kLatticeBound) return corrupt_cloud("a coordinate lies beyond 2^23 quanta");
  }
  return {};
}

/// Reads the values, which take no more bytes than the largest needs.
Result<std::vector<std::uint16_t>> read_values(const Body& body) {
  std::vector<std::uint16_t> values(body.head.value_bytes == 0 ? 0 : body.head.count);
  std::uint16_t most = 0;
  for (std::size_t at = 0; at < values.size(); ++at) {
    values[at] = body.value(at);
    most = std::max(most, values[at]);
  }
  const bool is_tight = body.head.value_bytes == 2 ? most > 0xff : body.head.value_bytes == 0 || !values.empty();
  if (!is_tight) return corrupt_cloud("its values take more bytes than they need");
  return values;
}

Result<Body> split_canonical(ByteView canonical) {
  if (auto magic = check_magic(canonical, kCanonicalMagic); !magic) return fail(magic.error());
  ByteReader in(canonical.subspan(kMagicBytes));
  Body body{read_head(in), {}, {}, {}};
  if (!in.ok()) return fail(in.finish("cloud").error());
  if (canonical.size() != body.head.canonical_size()) {
    return wrong_size(body.head, canonical.size());
  }
  const ByteView rest = canonical.subspan(kMagicBytes + kHeadBytes);
  body.codes = rest.first(body.head.count * sizeof(std::uint64_t));
  body.values = rest.subspan(body.codes.size(), std::size_t{body.head.count} * body.head.value_bytes);
  body.attached = rest.subspan(body.codes.size() + body.values.size());
  return body;
}

}  // namespace

Result<LatticeCloud> decode_cloud(ByteView canonical) {
  const auto body = split_canonical(canonical);
  if (!body) return fail(body.error());
  if (auto order = check_order(*body); !order) return fail(order.error());
  auto values = read_values(*body);
  if (!values) return fail(values.error());
  Placed placed = place_points(*body);
  if (auto bounds = check_bounds(body->head, placed); !bounds) return fail(bounds.error());
  return LatticeCloud{
      {std::move(placed.points), std::move(*values), Bytes(body->attached.begin(), body->attached.end())},
      body->head.quantum_um};
}

}  // namespace weft::clouds
