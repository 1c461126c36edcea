#include "clients/evaluate/particles/carmen_log.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "clients/evaluate/files.hpp"
#include "core/text.hpp"
#include "storage/formats/gzip.hpp"

namespace weft::evaluate::particles {
namespace {

constexpr double kFarthestM = 10'000.0;
constexpr std::size_t kWordsBeside = 11;  // FLASER, n, two poses, time, host, time
constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

std::vector<std::string_view> words_in(std::string_view line) {
  constexpr std::string_view spaces = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(spaces); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(spaces, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(spaces, end);
  }
  return words;
}

/// Returns the whole word as a finite number.
std::optional<double> finite_number(std::string_view word) {
  double number = 0.0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

/// Reads one line that begins with FLASER; errors are what is wrong with it.
tl::expected<LaserScan, std::string> scan_of(const std::vector<std::string_view>& words) {
  const std::optional<std::uint64_t> count = words.size() > 1 ? parse_unsigned(words[1]) : std::nullopt;
  if (!count || *count < 2 || *count > kMostRanges)
    return tl::unexpected("FLASER is not followed by a number of ranges in [2, " + std::to_string(kMostRanges) + "]");
  if (words.size() != *count + kWordsBeside)
    return tl::unexpected("FLASER of " + std::to_string(*count) + " ranges has " + std::to_string(words.size()) +
                          " words, not " + std::to_string(*count + kWordsBeside) +
                          ": the line is cut or run together");
  LaserScan scan;
  for (std::size_t i = 0; i < *count; ++i) {
    const std::optional<double> range = finite_number(words[2 + i]);
    if (!range || *range < 0.0 || *range > kFarthestM)
      return tl::unexpected("range " + std::to_string(i) + " is " + cited(words[2 + i]) + ", not in [0, 10000] m");
    scan.ranges_m.push_back(static_cast<float>(*range));
  }
  const std::optional<double> x = finite_number(words[2 + *count]);
  const std::optional<double> y = finite_number(words[3 + *count]);
  const std::optional<double> heading = finite_number(words[4 + *count]);
  if (!x || !y || !heading || std::abs(*x) > kFarthestM || std::abs(*y) > kFarthestM)
    return tl::unexpected(std::string("the pose behind the ranges is not three numbers, within 10 km"));
  scan.map_from_laser = {*x, *y, wrap_angle(*heading)};
  return scan;
}

}  // namespace

double LaserScan::bearing_rad(std::size_t i) const {
  const std::size_t steps = ranges_m.size() % 2 == 0 ? ranges_m.size() : ranges_m.size() - 1;
  return std::numbers::pi * (static_cast<double>(i) / static_cast<double>(steps) - 0.5);
}

Result<std::vector<LaserScan>> read_carmen(std::string_view text, const std::string& file) {
  std::vector<LaserScan> scans;
  std::size_t number = 0;
  for (std::string_view rest = without_byte_order_mark(text); !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    ++number;
    const std::vector<std::string_view> words = words_in(line);
    if (words.empty() || words[0] != "FLASER") continue;
    tl::expected<LaserScan, std::string> scan = scan_of(words);
    if (!scan) return fail_at(file, number, scan.error());
    if (!scans.empty() && scans.front().ranges_m.size() != scan->ranges_m.size())
      return fail_at(file, number,
                     "a scan of " + std::to_string(scan->ranges_m.size()) + " ranges, those before have " +
                         std::to_string(scans.front().ranges_m.size()) + "; one laser is wanted");
    if (scans.size() == kMostScans)
      return fail_at(file, number, "more than " + std::to_string(kMostScans) + " scans; cut the log");
    scans.push_back(*std::move(scan));
  }
  if (scans.size() < kFewestScans)
    return fail(ErrorCode::invalid, file + ": holds " + std::to_string(scans.size()) + " FLASER lines, at least " +
                                        std::to_string(kFewestScans) +
                                        " are wanted; give a CARMEN log with corrected poses");
  return scans;
}

Result<std::vector<LaserScan>> read_carmen_file(const std::filesystem::path& file) {
  const Result<std::string> stored = read_text(file, "CARMEN log");
  if (!stored) return fail(stored.error());
  const ByteView bytes(reinterpret_cast<const std::uint8_t*>(stored->data()), stored->size());
  if (!formats::is_gzip(bytes)) return read_carmen(*stored, file.string());
  const Result<Bytes> text = formats::gunzip(bytes, kMostBytes);
  if (!text) return fail(text.error().code, file.string() + ": " + text.error().message);
  return read_carmen(text_in(*text), file.string());
}

}  // namespace weft::evaluate::particles
