#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::clouds {

/// Holds points in metres in the frame that their content says, one number each or none (intensity, ring, class), and
/// what else their content says (poses, features), whose meaning only its method knows.
struct Cloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint16_t> values;  ///< empty, or one a point
  Bytes attached{};

  friend bool operator==(const Cloud&, const Cloud&) = default;
};

/// Keeps points within 0.55 mm an axis and 1 mm in distance (docs/formats/cloud.md).
inline constexpr std::uint32_t kFineQuantum_um = 1100;
inline constexpr std::uint32_t kLargestQuantum_um = 1'000'000;

/// Holds a cloud as its canonical bytes say it: in the order of Morton codes, every coordinate on the lattice.
struct LatticeCloud {
  Cloud cloud;
  std::uint32_t quantum_um = 0;
};

/// Returns the bytes of a cloud that are hashed: the same for the same points in any order. Each coordinate x is kept
/// within quantum / 2 + |x| 2^-24, values and what is attached exactly; the order of the points is not kept. invalid,
/// with the point and the bound: a quantum outside [1, kLargestQuantum_um], coordinates that are not finite or beyond
/// 2^23 quanta, a cloud of 2^21 quanta or more on an axis, values that are not one a point. exhausted: more than
/// kLargestContent bytes.
Result<Bytes> canonical_bytes(const Cloud& cloud, std::uint32_t quantum_um);

/// Reads a cloud from its canonical bytes. corrupt or newer: bytes that canonical_bytes does not write.
Result<LatticeCloud> decode_cloud(ByteView canonical);

/// Returns whether a content is a cloud, which a store may keep compressed: by its first bytes alone.
bool is_cloud(ByteView content);

/// Returns the compressed form that a store keeps. corrupt or newer: its head or the order of its codes is none of
/// canonical_bytes.
Result<Bytes> compress_cloud(ByteView canonical);

/// Returns how many bytes expand_cloud would make of it, by its head alone. corrupt or newer.
Result<std::uint64_t> expanded_size(ByteView compressed);

/// Returns the very bytes that were compressed. corrupt or newer; takes at most a few times kLargestContent of
/// memory.
Result<Bytes> expand_cloud(ByteView compressed);

}  // namespace weft::clouds
