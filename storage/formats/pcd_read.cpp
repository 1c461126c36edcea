#include <set>

#include "storage/formats/cloud_points.hpp"
#include "storage/formats/lines.hpp"
#include "storage/formats/lzf.hpp"
#include "storage/formats/unit.hpp"

namespace weft::formats {
namespace {

using Words = std::vector<std::string_view>;

class PcdReader {
 public:
  PcdReader(ByteView bytes, std::string_view file) : bytes_(bytes), lines_(text_in(bytes)), file_(file) {}

  Result<Read<Cloud>> run() {
    if (const Result<void> read = header(); !read) return fail(read.error());
    if (const Result<void> fits = check_header(); !fits) return fail(fits.error());
    if (const auto begun = builder_.begin(fields_, points_, file_, leftovers_); !begun) return fail(begun.error());
    const Result<void> read = points();
    if (!read) return fail(read.error());
    Cloud cloud = builder_.take();
    cloud.width = width_;
    cloud.height = height_;
    cloud.world_from_sensor = world_from_sensor_;
    return Read<Cloud>{std::move(cloud), leftovers_.take()};
  }

 private:
  tl::unexpected<Error> wrong(const std::string& what) const { return fail_at(file_, lines_.number(), what); }
  tl::unexpected<Error> damaged(const std::string& what) const {
    return fail(ErrorCode::corrupt, std::string(file_) + ": " + what);
  }

  Result<void> header() {
    while (const std::optional<std::string_view> line = lines_.next()) {
      const Words words = words_of(*line);
      if (words.empty() || words.front().starts_with('#')) continue;
      if (const Result<void> taken = entry(words); !taken) return taken;
      if (words.front() == "DATA") return {};
    }
    return wrong("the header has no DATA line; is this a PCD file?");
  }

  Result<void> entry(const Words& words) {
    const std::string_view key = words.front();
    const std::string_view name = key == "COLUMNS" ? "FIELDS" : key;  // so called in version 0.5
    if (!seen_.insert(std::string(name)).second) return wrong(cited(key) + " stands there a second time");
    if (name == "FIELDS") {
      for (std::size_t i = 1; i < words.size(); ++i) fields_.push_back({.name = std::string(words[i])});
      for (CloudField& field : fields_) field.line = lines_.number();
      return {};
    }
    if (key == "TYPE") {
      if (words.size() != 1 + fields_.size()) return wrong("TYPE must name one for each of FIELDS");
      for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i].type = words[i + 1].front();
      return {};
    }
    if (key == "SIZE") return each(words, &CloudField::size);
    if (key == "COUNT") return each(words, &CloudField::count);
    if (key == "WIDTH") return one(words, width_);
    if (key == "HEIGHT") return one(words, height_);
    if (key == "POINTS") return one(words, points_);
    if (key == "VIEWPOINT") return viewpoint(words);
    if (key == "VERSION") return version(words);
    if (key == "DATA") {
      static const std::set<std::string_view> kCodings = {"ascii", "binary", "binary_compressed"};
      if (words.size() != 2 || !kCodings.contains(words[1])) {
        return wrong("DATA must be ascii, binary or binary_compressed");
      }
      coding_ = words[1];
      return {};
    }
    leftovers_.note(key, lines_.number());
    return {};
  }

  Result<void> version(const Words& words) {
    static const std::set<std::string_view> kVersions = {"0.7", ".7", "0.6", ".6", "0.5", ".5"};
    if (words.size() != 2 || !kVersions.contains(words[1])) {
      return wrong("version " + std::string(words.size() > 1 ? words[1] : "(none)") + " is not read, 0.5 to 0.7 are");
    }
    is_complete_ = words[1].ends_with('7');
    return {};
  }

  Result<void> each(const Words& words, std::size_t CloudField::*member) {
    if (words.size() != 1 + fields_.size()) {
      return wrong(std::string(words.front()) + " must have a number for each of FIELDS, which stands before it");
    }
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      constexpr std::uint64_t kMost = 1U << 16U;
      const std::optional<std::uint64_t> number = parse_unsigned(words[i + 1]);
      if (!number.has_value() || *number == 0 || *number > kMost) {
        return wrong(cited(words[i + 1]) + " is no number in [1, 65536]");
      }
      fields_[i].*member = *number;
    }
    return {};
  }

  Result<void> one(const Words& words, std::uint64_t& into) const {
    constexpr std::uint64_t kMost = 1ULL << 32U;
    const std::optional<std::uint64_t> number = words.size() == 2 ? parse_unsigned(words[1]) : std::nullopt;
    if (!number.has_value() || *number > kMost) {
      return wrong(std::string(words.front()) + " must be a whole number up to 2^32");
    }
    into = *number;
    return {};
  }

  Result<void> viewpoint(const Words& words) {
    std::vector<double> numbers;
    for (std::size_t i = 1; i < words.size(); ++i) numbers.push_back(parse_finite(words[i]).value_or(9.0));
    const auto unit = numbers.size() == 7 ? unit_quaternion(numbers[3], numbers[4], numbers[5], numbers[6])
                                          : std::optional<Eigen::Quaterniond>{};
    if (!unit.has_value()) return wrong("VIEWPOINT must be x y z and a unit quaternion w x y z");
    world_from_sensor_ = {*unit, {numbers[0], numbers[1], numbers[2]}};
    return {};
  }

  Result<void> check_header() {
    if (!seen_.contains("FIELDS")) return wrong("the header has no FIELDS");
    for (const char* const key : {"SIZE", "TYPE", "WIDTH"}) {
      if (is_complete_ && !seen_.contains(key)) {
        return wrong(std::string("the header has no ") + key + ", which version 0.7 needs");
      }
    }
    if (!seen_.contains("WIDTH") && !seen_.contains("POINTS"))
      return wrong("the header has neither WIDTH nor POINTS");
    if (!seen_.contains("WIDTH") && height_ > 0) width_ = points_ / height_;
    if (!seen_.contains("POINTS")) points_ = width_ * height_;
    if (width_ * height_ != points_) {
      return wrong("WIDTH " + std::to_string(width_) + " times HEIGHT " + std::to_string(height_) +
                   " is not POINTS " + std::to_string(points_));
    }
    for (const CloudField& field : fields_) {
      const bool is_coordinate = field.name == "x" || field.name == "y" || field.name == "z";
      if (is_coordinate && !is_number(field.type, field.size)) {
        return fail_at(file_, field.line,
                       "field " + field.name + " has type " + field.type + " of " + std::to_string(field.size) +
                           " bytes, which is no number");
      }
    }
    stride_ = stride_of(fields_);
    if (coding_ == "binary_compressed") return {};
    return check_room(fields_, points_, coding_ == "ascii", bytes_.size() - lines_.offset(), file_);
  }

  Result<void> points() {
    if (coding_ == "binary_compressed") return compressed();
    if (coding_ == "ascii") {
      const Result<void> read = read_text_points(lines_, fields_, points_, true, file_, builder_);
      if (read) note_rows_left(lines_, 0, true, leftovers_);
      return read;
    }
    const ByteView data = bytes_.subspan(lines_.offset());
    const Result<void> read = read_binary_points(data, fields_, points_, false, false, file_, builder_);
    if (read) note_bytes_left(data.subspan(points_ * stride_), lines_.number() + 1, leftovers_);
    return read;
  }

  Result<void> compressed() {
    const ByteView data = bytes_.subspan(lines_.offset());
    constexpr std::size_t kHead = 8;
    if (data.size() < kHead) return damaged("the compressed points end within their sizes");
    const auto size_at = [&data](std::size_t at) {
      return data[at] | (std::size_t{data[at + 1]} << 8U) | (std::size_t{data[at + 2]} << 16U) |
             (std::size_t{data[at + 3]} << 24U);
    };
    const std::size_t packed = size_at(0);
    const std::size_t plain = size_at(4);
    // 264 bytes come out of three at most.
    if (packed > data.size() - kHead || plain / 88 > packed) {
      return damaged("the file ends after " + std::to_string(data.size() - kHead) + " of " + std::to_string(packed) +
                     " compressed bytes");
    }
    if (stride_ == 0 || plain / stride_ != points_ || plain % stride_ != 0) {
      return damaged(std::to_string(plain) + " bytes are stated to be " + std::to_string(points_) + " points of " +
                     std::to_string(stride_) + " bytes");
    }
    const Result<Bytes> points = lzf_decompress(data.subspan(kHead, packed), plain);
    if (!points) return damaged(points.error().message);
    note_bytes_left(data.subspan(kHead + packed), lines_.number() + 1, leftovers_);
    return read_binary_points(*points, fields_, points_, true, false, file_, builder_);
  }

  ByteView bytes_;
  Lines lines_;
  std::string_view file_;
  std::set<std::string> seen_;
  std::vector<CloudField> fields_;
  std::uint64_t width_ = 0;
  std::uint64_t height_ = 1;
  std::uint64_t points_ = 0;
  std::size_t stride_ = 0;  // bytes of a point
  Pose3 world_from_sensor_;
  std::string_view coding_;
  bool is_complete_ = false;  // of version 0.7, whose headers leave nothing to be assumed
  CloudBuilder builder_;
  Leftovers leftovers_;
};

}  // namespace

Result<Read<Cloud>> read_pcd(ByteView bytes, std::string_view file) {
  return PcdReader(bytes, file).run();
}

}  // namespace weft::formats
