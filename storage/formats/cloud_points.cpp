#include "storage/formats/cloud_points.hpp"

#include <algorithm>
#include <numeric>

#include "storage/formats/not_understood.hpp"

namespace weft::formats {
namespace {

std::size_t numbers_of(const std::vector<CloudField>& fields) {
  return std::accumulate(fields.begin(), fields.end(), std::size_t{0},
                         [](std::size_t sum, const CloudField& field) { return sum + field.count; });
}

tl::unexpected<Error> damaged(std::string_view file, const std::string& what) {
  return fail(ErrorCode::corrupt, std::string(file) + ": " + what);
}

}  // namespace

std::size_t stride_of(const std::vector<CloudField>& fields) {
  return std::accumulate(fields.begin(), fields.end(), std::size_t{0},
                         [](std::size_t sum, const CloudField& field) { return sum + field.bytes(); });
}

Result<void> check_room(const std::vector<CloudField>& fields, std::uint64_t points, bool is_text, std::size_t rest,
                        std::string_view file) {
  const std::size_t least = is_text ? 2 * numbers_of(fields) : stride_of(fields);
  // The last line of a text may lack its end.
  if (least == 0 || points <= (rest + 1) / least) return {};
  return damaged(file, "the header states " + std::to_string(points) + " points, the " + std::to_string(rest) +
                           " bytes after it cannot hold them");
}

Result<void> read_text_points(Lines& lines, const std::vector<CloudField>& fields, std::uint64_t points,
                              bool has_comments, std::string_view file, CloudBuilder& builder) {
  const std::size_t numbers = numbers_of(fields);
  for (std::size_t point = 0; point < points;) {
    const std::optional<std::string_view> line = lines.next();
    const auto wrong = [&](const std::string& what) { return fail_at(file, lines.number(), what); };
    if (!line.has_value()) {
      return wrong("the file ends after " + std::to_string(point) + " of " + std::to_string(points) + " points");
    }
    const std::vector<std::string_view> words = words_of(*line);
    if (words.empty() || (has_comments && words.front().starts_with('#'))) continue;
    if (words.size() != numbers) {
      return wrong("a point has " + std::to_string(words.size()) + " numbers, it needs " + std::to_string(numbers));
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < fields.size(); at += fields[i++].count) {
      if (!builder.takes(i)) continue;
      const std::optional<double> number = parse_double(words[at]);
      if (!number.has_value() || !builder.put(i, point, *number)) {
        return wrong(cited(words[at]) + " cannot be " + fields[i].name);
      }
    }
    ++point;
  }
  return {};
}

void note_rows_left(Lines& lines, std::uint64_t expected, bool has_comments, Leftovers& leftovers) {
  std::uint64_t rows = 0;
  while (const std::optional<std::string_view> line = lines.next()) {
    const std::string_view row = trimmed(*line);
    if (row.empty() || (has_comments && row.starts_with('#'))) continue;
    if (++rows > expected) leftovers.note("a row after the last point", lines.number());
  }
}

void note_bytes_left(ByteView rest, std::size_t line, Leftovers& leftovers) {
  const bool is_padding = std::all_of(rest.begin(), rest.end(), [](std::uint8_t byte) { return byte == 0; });
  if (!is_padding) leftovers.note(std::to_string(rest.size()) + " bytes after the last point", line);
}

Result<void> read_binary_points(ByteView data, const std::vector<CloudField>& fields, std::uint64_t points,
                                bool by_field, bool big_endian, std::string_view file, CloudBuilder& builder) {
  const std::size_t stride = stride_of(fields);
  if (data.size() < points * stride) return damaged(file, "the points end early");
  std::size_t offset = 0;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t step = by_field ? fields[i].bytes() : stride;
    for (std::size_t point = 0; builder.takes(i) && point < points; ++point) {
      if (builder.put(i, point, data.data() + offset + point * step, big_endian)) continue;
      return damaged(file, "point " + std::to_string(point) + ": " + fields[i].name + " is infinite");
    }
    offset += by_field ? fields[i].bytes() * points : fields[i].bytes();
  }
  return {};
}

}  // namespace weft::formats
