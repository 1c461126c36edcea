#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"
#include "storage/formats/cloud_fields.hpp"
#include "storage/formats/lines.hpp"

/// Holds functions that all files of points share, whatever their headers are like.
namespace weft::formats {

/// Returns the bytes of a point.
std::size_t stride_of(const std::vector<CloudField>& fields);

/// Checks the number of points that a header states before anything is made of it. corrupt: `rest` bytes cannot hold
/// them, each number of text taking two.
Result<void> check_room(const std::vector<CloudField>& fields, std::uint64_t points, bool is_text, std::size_t rest,
                        std::string_view file);

/// Reads points from lines of numbers, field by field; empty lines are none, nor are those that begin with # where
/// there are comments. invalid: names the line.
Result<void> read_text_points(Lines& lines, const std::vector<CloudField>& fields, std::uint64_t points,
                              bool has_comments, std::string_view file, CloudBuilder& builder);

/// Notes what follows the last point, of which a file may have more than its header states: rows of text, `expected`
/// of them another element's, or bytes that are not all zero (PCL fills the last page of memory up).
void note_rows_left(Lines& lines, std::uint64_t expected, bool has_comments, Leftovers& leftovers);
void note_bytes_left(ByteView rest, std::size_t line, Leftovers& leftovers);

/// Reads points from bytes. `by_field`: the first field of all points, then the second one; else point by point.
/// corrupt: ends early, or a number is infinite.
Result<void> read_binary_points(ByteView data, const std::vector<CloudField>& fields, std::uint64_t points,
                                bool by_field, bool big_endian, std::string_view file, CloudBuilder& builder);

}  // namespace weft::formats
