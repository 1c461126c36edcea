#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"

namespace weft::formats {

/// Gives the lines of a text one after the other, without its byte order mark; LF and CR LF both end one.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text), offset_(text.size() - without_byte_order_mark(text).size()) {}

  std::optional<std::string_view> next();
  /// Returns the number, from 1, of the line that `next` gave last.
  std::size_t number() const { return number_; }
  /// Returns where the next line begins in the text, in bytes.
  std::size_t offset() const { return offset_; }

 private:
  std::string_view text_;
  std::size_t offset_;
  std::size_t number_ = 0;
};

/// Returns the words of a line: what blanks and tabs separate.
std::vector<std::string_view> words_of(std::string_view line);
/// Returns the cells of a line: what `separator` separates, without blanks around them; empty ones count.
std::vector<std::string_view> cells_of(std::string_view line, char separator);
std::string_view trimmed(std::string_view text);

/// Returns the whole of `word` as a number; none if it is none, or does not fit. NaN and infinities are numbers here.
std::optional<double> parse_double(std::string_view word);
/// Returns the same number; none unless it is finite.
std::optional<double> parse_finite(std::string_view word);

/// Return the shortest text that reads back as the same bits.
std::string text_of(double value);
std::string text_of(float value);

}  // namespace weft::formats
