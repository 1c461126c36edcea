#include "images/pgm.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <utility>

#include "core/text.hpp"

namespace weft::images {
namespace {

/// Gives the words of a PGM header, comments left out, with the line they stand in.
class HeaderWords {
 public:
  explicit HeaderWords(std::string_view text)
      : text_(text), at_(text.size() - without_byte_order_mark(text).size()) {}

  std::optional<std::string_view> next() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) == 0) ++at_;
    if (at_ == begin) return std::nullopt;
    return text_.substr(begin, at_ - begin);
  }
  std::size_t line() const { return line_; }
  std::size_t at() const { return at_; }

 private:
  void skip() {
    for (bool comment = false; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '#') comment = true;
      if (!comment && std::isspace(static_cast<unsigned char>(c)) == 0) return;
      if (c == '\n') {
        comment = false;
        ++line_;
      }
    }
  }

  std::string_view text_;
  std::size_t at_;
  std::size_t line_ = 1;
};

class PgmReader {
 public:
  PgmReader(ByteView bytes, std::string_view file) : bytes_(bytes), words_(text_in(bytes)), file_(file) {}

  Result<Pgm> run() {
    const std::string_view magic = words_.next().value_or("");
    if (magic != "P5" && magic != "P2") return wrong("the file begins with neither P5 nor P2");
    std::uint32_t white = 0;
    for (auto [into, what] : {std::pair{&image_.width, "width"}, {&image_.height, "height"}, {&white, "white"}}) {
      constexpr std::uint64_t kMost = 65'535;
      const std::optional<std::string_view> word = words_.next();
      const std::optional<std::uint64_t> number = word.has_value() ? parse_unsigned(*word) : std::nullopt;
      if (!number.has_value() || *number == 0 || *number > kMost) {
        return wrong(std::string("the ") + what + " must be a whole number in [1, 65535]");
      }
      *into = static_cast<std::uint32_t>(*number);
    }
    image_.white = static_cast<std::uint16_t>(white);
    const Result<void> read = magic == "P5" ? binary() : text();
    if (!read) return fail(read.error());
    return std::move(image_);
  }

 private:
  tl::unexpected<Error> wrong(const std::string& what) const { return fail_at(file_, words_.line(), what); }

  void note_rest(std::string_view kind) {
    image_.rest = kind;
    image_.rest_line = words_.line();
  }

  std::size_t size() const { return std::size_t{image_.width} * image_.height; }

  Result<void> binary() {
    constexpr std::uint16_t kOneByte = 255;
    const std::size_t each = image_.white > kOneByte ? 2 : 1;
    const std::size_t begin = std::min(words_.at() + 1, bytes_.size());  // one blank ends the header
    const ByteView data = bytes_.subspan(begin);
    if (data.size() / each < size()) {
      return fail(ErrorCode::corrupt, std::string(file_) + ": the image ends after " +
                                          std::to_string(data.size() / each) + " of " + std::to_string(size()) +
                                          " pixels");
    }
    image_.pixels.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const auto value =
          static_cast<std::uint16_t>(each == 1 ? data[i] : (std::uint32_t{data[2 * i]} << 8U) | data[2 * i + 1]);
      if (value > image_.white) {
        return fail(ErrorCode::corrupt, std::string(file_) + ": pixel " + std::to_string(i) + " is " +
                                            std::to_string(value) + ", above white, " + std::to_string(image_.white));
      }
      image_.pixels.push_back(value);
    }
    if (data.size() > each * size()) note_rest("bytes");
    return {};
  }

  Result<void> text() {
    if (bytes_.size() / 2 + 1 < size()) return wrong("the file is too short for its pixels");
    image_.pixels.reserve(size());
    for (std::size_t i = 0; i < size(); ++i) {
      const std::optional<std::string_view> word = words_.next();
      if (!word.has_value()) {
        return wrong("the image ends after " + std::to_string(i) + " of " + std::to_string(size()) + " pixels");
      }
      const std::optional<std::uint64_t> value = parse_unsigned(*word);
      if (!value.has_value() || *value > image_.white) {
        return wrong(cited(*word) + " is no pixel in [0, " + std::to_string(image_.white) + "]");
      }
      image_.pixels.push_back(static_cast<std::uint16_t>(*value));
    }
    if (words_.next().has_value()) note_rest("words");
    return {};
  }

  ByteView bytes_;
  HeaderWords words_;
  std::string_view file_;
  Pgm image_;
};

/// Returns the grey as one of 255; two bytes become the upper one.
std::uint8_t byte_of(std::uint16_t grey, std::uint16_t white) {
  constexpr std::uint32_t kFull = 255;
  constexpr std::uint16_t kTwoBytes = 65'535;
  if (white == kTwoBytes) return static_cast<std::uint8_t>(grey >> 8U);
  return static_cast<std::uint8_t>(grey * kFull / white);
}

}  // namespace

bool is_pgm(ByteView bytes) {
  return bytes.size() >= 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5');
}

Result<Pgm> read_pgm(ByteView bytes, std::string_view file) {
  return PgmReader(bytes, file).run();
}

Result<Picture> decode_pgm(ByteView bytes, std::string_view file, Shades shades) {
  const Result<Pgm> pgm = read_pgm(bytes, file);
  if (!pgm) return fail(pgm.error());
  Result<Picture> picture = blank_picture(file, shades, pgm->width, pgm->height);
  if (!picture) return picture;
  auto at = picture->samples.begin();
  for (const std::uint16_t grey : pgm->pixels)
    at = std::fill_n(at, static_cast<int>(shades), byte_of(grey, pgm->white));
  return picture;
}

}  // namespace weft::images
