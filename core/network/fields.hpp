#pragma once
#include "core/byte_reader.hpp"
#include "core/byte_writer.hpp"
#include "core/network/change.hpp"
#include "core/network/network.hpp"

/// Writes and reads fields of records as they stand inside other records, without the leading format byte. Private to
/// the codec.
namespace weft::fields {

inline constexpr std::uint8_t kFormat = 1;  ///< first byte of every record

void write(ByteWriter& out, const Relation& relation);
void write(ByteWriter& out, const Place& place);
void write(ByteWriter& out, const Edge& edge);

Relation read_relation(ByteReader& in);
Place read_place(ByteReader& in);
Edge read_edge(ByteReader& in);

/// Reads a number, which is corrupt when it is not from `least` to `most`.
double read_within(ByteReader& in, const char* field, double least, double most);
/// Write and read a point within `kPlanReach_m`, x before y.
void write(ByteWriter& out, const Eigen::Vector2d& point);
Eigen::Vector2d read_point(ByteReader& in, const char* field);

// Fewest bytes of a record's fields: bounds the counts that a reader believes.
inline constexpr std::size_t kRelationLeast = 1 + 4 * 8;
inline constexpr std::size_t kPlaceLeast = 12 + 4 + 4 + 4 + 32 + 8 + 16 + 8 + 8;
inline constexpr std::size_t kEdgeLeast = 24 + 4 + kRelationLeast + 1 + 4 + 1 + 4 + 4;
inline constexpr std::size_t kPlaceIdBytes = 12;
inline constexpr std::size_t kPointBytes = 2 * 8;

/// Write and read a whole record: format byte, fields, nothing after them.
template <class Fields>
Bytes record(Fields&& write_fields) {
  ByteWriter out;
  out.reserve(256);
  out.number(kFormat);
  write_fields(out);
  return out.take();
}
template <class T, class Read>
Result<T> whole(ByteView bytes, const char* what, Read&& read) {
  ByteReader in(bytes);
  in.ranged<std::uint8_t>("format", kFormat, kFormat);
  T value = read(in);
  const Result<void> end = in.finish(what);
  if (!end) return fail(end.error());
  return value;
}

}  // namespace weft::fields
