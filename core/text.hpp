#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/bytes.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft {

/// Puts a text on one line, for messages that end a program: line breaks at the end go, those in between become "; ".
std::string one_line(std::string text);

/// Writes a number as people do: 5, not 5.000000; six digits at most.
std::string short_number(double number);

/// Writes a number with so many digits behind the point.
std::string fixed_number(double number, int digits);

/// Writes a time as ISO 8601 in UTC, to the millisecond: 2026-03-01T09:30:05.250Z.
std::string iso_time(WallTime at);

/// Returns the text without the UTF-8 byte order mark that some editors put first. Every reader of text begins so.
std::string_view without_byte_order_mark(std::string_view text);

/// Returns bytes as the text that they are.
std::string_view text_in(ByteView bytes);

/// Returns the word in quotes, clipped to 40 bytes, for messages.
std::string cited(std::string_view word);

/// Returns the whole of `word` as a number; none if it is none, or does not fit.
std::optional<std::uint64_t> parse_unsigned(std::string_view word);

/// Returns a failure. invalid: "file:line: what".
tl::unexpected<Error> fail_at(std::string_view file, std::size_t line, std::string_view what);

}  // namespace weft
