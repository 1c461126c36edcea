#include "clients/cli/since.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <ctime>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/text.hpp"

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr std::array<std::pair<std::string_view, Duration>, 4> kUnits = {
    {{"s", 1s}, {"min", 60s}, {"h", 3600s}, {"d", 24h}}};
constexpr std::uint64_t kMostDays = 36'500;

std::optional<Duration> parse_ago(std::string_view text) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::optional<std::uint64_t> number = parse_unsigned(text.substr(0, digits));
  if (!number) return std::nullopt;
  for (const auto& [name, unit] : kUnits) {
    const std::uint64_t most = kMostDays * static_cast<std::uint64_t>(24h / unit);
    if (text.substr(digits) == name && *number <= most) return unit * static_cast<Duration::rep>(*number);
  }
  return std::nullopt;
}

/// Returns the fraction of a second that follows a time: ".250Z" or "Z".
std::optional<Duration> parse_fraction(std::string_view text) {
  if (text == "Z") return Duration{};
  if (text.size() < 3 || text.size() > 11 || text.front() != '.' || text.back() != 'Z') return std::nullopt;
  const std::string digits(text.substr(1, text.size() - 2));
  const std::optional<std::uint64_t> nanoseconds = parse_unsigned(digits + std::string(9 - digits.size(), '0'));
  return nanoseconds ? std::optional<Duration>(static_cast<Duration::rep>(*nanoseconds)) : std::nullopt;
}

std::optional<WallTime> parse_time(const std::string& text) {
  constexpr std::size_t whole = 19;  // 2026-03-01T09:30:05
  if (text.size() <= whole) return std::nullopt;
  std::tm parts{};
  std::istringstream in(text.substr(0, whole));
  if (!(in >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%S"))) return std::nullopt;
  const std::optional<Duration> fraction = parse_fraction(std::string_view(text).substr(whole));
  if (!fraction) return std::nullopt;
  const WallTime at{std::chrono::seconds(timegm(&parts))};
  // A day or an hour that is none comes out as another one.
  if (iso_time(at).substr(0, whole) != text.substr(0, whole)) return std::nullopt;
  return at + *fraction;
}

}  // namespace

Result<Since> parse_since(const std::string& text) {
  if (const std::optional<Duration> ago = parse_ago(text)) return Since{std::nullopt, *ago};
  if (const std::optional<WallTime> at = parse_time(text)) return Since{at, {}};
  return fail(ErrorCode::invalid,
              cited(text) +
                  " is no time: give how long ago (90s, 10min, 2h, 1d; at most 36500d), or a time "
                  "in UTC as logs have it (2026-03-01T09:30:05Z)");
}

}  // namespace weft::cli
