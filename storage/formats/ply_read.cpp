#include <map>

#include "storage/formats/cloud_points.hpp"
#include "storage/formats/lines.hpp"

namespace weft::formats {
namespace {

using Words = std::vector<std::string_view>;

class PlyReader {
 public:
  PlyReader(ByteView bytes, std::string_view file) : bytes_(bytes), lines_(text_in(bytes)), file_(file) {}

  Result<Read<Cloud>> run() {
    if (lines_.next().value_or("") != "ply") return fail_at(file_, 1, "the file does not begin with the line 'ply'");
    if (const Result<void> read = header(); !read) return fail(read.error());
    if (const Result<void> fits = check_header(); !fits) return fail(fits.error());
    if (const auto begun = builder_.begin(fields_, points_, file_, leftovers_); !begun) return fail(begun.error());
    const Result<void> read = points();
    if (!read) return fail(read.error());
    return Read<Cloud>{builder_.take(), leftovers_.take()};
  }

 private:
  enum class Part { before, vertex, after };

  tl::unexpected<Error> wrong(const std::string& what) const { return fail_at(file_, lines_.number(), what); }

  Result<void> header() {
    while (const std::optional<std::string_view> line = lines_.next()) {
      const Words words = words_of(*line);
      if (words.empty() || words.front() == "comment" || words.front() == "obj_info") continue;
      if (words.front() == "end_header") return {};
      if (const Result<void> taken = entry(words); !taken) return taken;
    }
    return wrong("the header has no end_header");
  }

  Result<void> entry(const Words& words) {
    if (words.front() == "format") return format(words);
    if (words.front() == "element") return element(words);
    if (words.front() == "property") return property(words);
    leftovers_.note(words.front(), lines_.number());
    return {};
  }

  Result<void> format(const Words& words) {
    if (words.size() != 3 || words[2] != "1.0" ||
        (words[1] != "ascii" && words[1] != "binary_little_endian" && words[1] != "binary_big_endian")) {
      return wrong("the format must be ascii, binary_little_endian or binary_big_endian, version 1.0");
    }
    coding_ = words[1];
    return {};
  }

  Result<void> element(const Words& words) {
    constexpr std::uint64_t kMost = 1ULL << 32U;
    const std::optional<std::uint64_t> count = words.size() == 3 ? parse_unsigned(words[2]) : std::nullopt;
    if (!count.has_value() || *count > kMost) return wrong("an element has a name and a count up to 2^32");
    if (words[1] == "vertex") {
      if (part_ != Part::before) return wrong("the element vertex stands there a second time");
      part_ = Part::vertex;
      points_ = *count;
      return {};
    }
    if (part_ == Part::before && *count > 0) {
      return wrong("element " + cited(words[1]) + " stands before vertex; files with vertex first are read");
    }
    if (part_ == Part::vertex) part_ = Part::after;
    rows_after_ += *count;
    leftovers_.note("element " + std::string(words[1]) + " of " + std::to_string(*count), lines_.number());
    return {};
  }

  Result<void> property(const Words& words) {
    if (part_ != Part::vertex) return {};  // of an element that is listed as a whole
    if (words.size() > 1 && words[1] == "list") return wrong("a vertex with a list is not read");
    static const std::map<std::string_view, std::pair<char, std::size_t>> kTypes = {
        {"char", {'I', 1}},    {"int8", {'I', 1}},   {"uchar", {'U', 1}},  {"uint8", {'U', 1}},  {"short", {'I', 2}},
        {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}}, {"int", {'I', 4}},    {"int32", {'I', 4}},
        {"uint", {'U', 4}},    {"uint32", {'U', 4}}, {"int64", {'I', 8}},  {"uint64", {'U', 8}}, {"float", {'F', 4}},
        {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
    const auto type = words.size() == 3 ? kTypes.find(words[1]) : kTypes.end();
    if (type == kTypes.end()) return wrong("a property has a type, such as float, and a name");
    fields_.push_back({.name = std::string(words[2]),
                       .type = type->second.first,
                       .size = type->second.second,
                       .count = 1,
                       .line = lines_.number()});
    return {};
  }

  Result<void> check_header() const {
    if (coding_.empty()) return wrong("the header has no format");
    if (part_ == Part::before) return wrong("the header has no element vertex");
    return check_room(fields_, points_, coding_ == "ascii", bytes_.size() - lines_.offset(), file_);
  }

  Result<void> points() {
    if (coding_ != "ascii") return binary_points();
    const Result<void> read = read_text_points(lines_, fields_, points_, false, file_, builder_);
    if (read) note_rows_left(lines_, rows_after_, false, leftovers_);
    return read;
  }

  Result<void> binary_points() {
    const ByteView data = bytes_.subspan(lines_.offset());
    const bool is_big_endian = coding_ == "binary_big_endian";
    const Result<void> read = read_binary_points(data, fields_, points_, false, is_big_endian, file_, builder_);
    const std::size_t size = points_ * stride_of(fields_);
    if (read && rows_after_ == 0) note_bytes_left(data.subspan(size), lines_.number() + 1, leftovers_);
    return read;
  }

  ByteView bytes_;
  Lines lines_;
  std::string_view file_;
  Part part_ = Part::before;
  std::string_view coding_;
  std::vector<CloudField> fields_;
  std::uint64_t points_ = 0;
  std::uint64_t rows_after_ = 0;  // of the elements after vertex
  CloudBuilder builder_;
  Leftovers leftovers_;
};

}  // namespace

Result<Read<Cloud>> read_ply(ByteView bytes, std::string_view file) {
  return PlyReader(bytes, file).run();
}

}  // namespace weft::formats
