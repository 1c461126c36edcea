#include "storage/formats/floor_plan.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <list>
#include <optional>
#include <set>

#include "storage/formats/lines.hpp"

namespace weft::formats {
namespace {

constexpr std::size_t kLongestYaml = 64U << 10U;

/// Takes the keys of one document, each once. Keeps the first error.
class Keys {
 public:
  Keys(const YAML::Node& document, std::string_view file) : file_(file) {
    for (const auto& entry : document) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : std::string("(a key that is no word)");
      if (!seen_.insert(key).second) wrong(entry.first, key + " stands there a second time");
      entries_.emplace_back(key, entry);
    }
  }

  std::optional<YAML::Node> take(const char* key) {
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (entry->first != key) continue;
      const YAML::Node value = entry->second.second;
      entries_.erase(entry);
      return value;
    }
    return std::nullopt;
  }

  std::optional<YAML::Node> need(const char* key) {
    std::optional<YAML::Node> value = take(key);
    if (!value.has_value()) wrong(1, std::string("the key ") + key + " is missing");
    return value;
  }

  double number(const YAML::Node& node, const char* key, double low, double high) {
    const std::optional<double> value = node.IsScalar() ? parse_finite(node.Scalar()) : std::nullopt;
    if (value.has_value() && *value >= low && *value <= high) return *value;
    wrong(node, std::string(key) + " must be a number in [" + text_of(low) + ", " + text_of(high) + "]");
    return low;
  }
  double need_number(const char* key, double low, double high) {
    const std::optional<YAML::Node> node = need(key);
    return node.has_value() ? number(*node, key, low, high) : low;
  }

  void wrong(const YAML::Node& node, const std::string& what) { wrong(line_of(node), what); }
  void wrong(std::size_t line, const std::string& what) {
    if (error_.message.empty()) error_ = fail_at(file_, line, what).value();
  }
  bool ok() const { return error_.message.empty(); }
  const Error& error() const { return error_; }

  void note_rest(Leftovers& leftovers) const {
    for (const auto& [key, entry] : entries_) leftovers.note(key, line_of(entry.first));
  }

 private:
  static std::size_t line_of(const YAML::Node& node) {
    return node.Mark().is_null() ? 1 : static_cast<std::size_t>(node.Mark().line) + 1;
  }

  std::string_view file_;
  std::set<std::string> seen_;
  // A list, because assigning a YAML::Node changes the document behind it.
  std::list<std::pair<std::string, std::pair<YAML::Node, YAML::Node>>> entries_;
  Error error_;
};

bool negate_of(Keys& keys) {
  const std::optional<YAML::Node> node = keys.need("negate");
  if (!node.has_value()) return false;
  const std::string word = node->IsScalar() ? node->Scalar() : std::string{};
  if (word == "0" || word == "1") return word == "1";
  bool negate = false;
  if (!YAML::convert<bool>::decode(*node, negate)) keys.wrong(*node, "negate must be 0, 1, false or true");
  return negate;
}

MapServerFile::Mode mode_of(Keys& keys) {
  const std::optional<YAML::Node> node = keys.take("mode");
  if (!node.has_value()) return MapServerFile::Mode::trinary;
  const std::string word = node->IsScalar() ? node->Scalar() : std::string{};
  if (word == "scale") return MapServerFile::Mode::scale;
  if (word == "raw") return MapServerFile::Mode::raw;
  if (word != "trinary") keys.wrong(*node, "mode must be trinary, scale or raw");
  return MapServerFile::Mode::trinary;
}

Pose2 origin_of(Keys& keys) {
  const std::optional<YAML::Node> node = keys.need("origin");
  if (!node.has_value()) return {};
  if (!node->IsSequence() || node->size() != 3) {
    keys.wrong(*node, "origin must be [x, y, heading] of the lower left pixel, metres and radians");
    return {};
  }
  constexpr double kFar = 1e6;
  const YAML::Node& list = *node;
  return {keys.number(list[0], "origin's x", -kFar, kFar), keys.number(list[1], "origin's y", -kFar, kFar),
          keys.number(list[2], "origin's heading", -kFar, kFar)};
}

/// Returns a pixel's shade: 0 black, 1 white. What is transparent is darker where a map has three values, as
/// map_server has it.
double shade_of(const MapServerFile& file, const GreyImage& image, std::size_t pixel) {
  const auto value = static_cast<double>(image.pixels[pixel]);
  if (image.opacities.empty() || file.mode != MapServerFile::Mode::trinary) return value / image.white;
  constexpr double kColours = 3.0;  // red, green and blue, of which the value is the mean
  return (kColours * value + image.opacities[pixel]) / ((kColours + 1.0) * image.white);
}

std::int8_t cell_of(const MapServerFile& file, const GreyImage& image, std::size_t pixel) {
  constexpr double kMost = 100.0;
  const double shade = shade_of(file, image, pixel);
  if (file.mode == MapServerFile::Mode::raw) {
    const double percent = std::round(shade * 255.0);
    return percent <= kMost ? static_cast<std::int8_t>(percent) : FloorPlan::kUnknown;
  }
  const bool is_scale = file.mode == MapServerFile::Mode::scale;
  if (is_scale && !image.opacities.empty() && image.opacities[pixel] < image.white) return FloorPlan::kUnknown;
  const double occupied = file.negate ? shade : 1.0 - shade;
  if (occupied > file.occupied_thresh) return 100;
  if (occupied < file.free_thresh) return 0;
  if (!is_scale) return FloorPlan::kUnknown;
  const double share = (occupied - file.free_thresh) / (file.occupied_thresh - file.free_thresh);
  return static_cast<std::int8_t>(std::rint(share * kMost));
}

}  // namespace

Result<Read<MapServerFile>> read_map_server(std::string_view text, std::string_view file) try {
  if (text.size() > kLongestYaml) return fail_at(file, 1, "a map_server file has at most 64 KiB");
  const YAML::Node document = YAML::Load(std::string(without_byte_order_mark(text)));
  if (!document.IsMap()) return fail_at(file, 1, "a map_server file is a list of 'key: value'");
  Keys keys(document, file);
  MapServerFile out;
  const std::optional<YAML::Node> image = keys.need("image");
  if (image.has_value()) {
    if (image->IsScalar()) out.image = image->Scalar();
    if (out.image.empty()) keys.wrong(*image, "image must be the name of a file");
  }
  constexpr double kCoarsest = 100.0;
  out.resolution_m = keys.need_number("resolution", 1e-6, kCoarsest);
  out.origin = origin_of(keys);
  out.negate = negate_of(keys);
  out.occupied_thresh = keys.need_number("occupied_thresh", 0.0, 1.0);
  out.free_thresh = keys.need_number("free_thresh", 0.0, 1.0);
  out.mode = mode_of(keys);
  if (keys.ok() && out.free_thresh >= out.occupied_thresh) keys.wrong(1, "free_thresh is not below occupied_thresh");
  if (!keys.ok()) return fail(keys.error());
  Leftovers leftovers;
  keys.note_rest(leftovers);
  return Read<MapServerFile>{out, leftovers.take()};
} catch (const YAML::Exception& problem) {
  return fail_at(file, problem.mark.is_null() ? 1 : static_cast<std::size_t>(problem.mark.line) + 1,
                 "no YAML: " + problem.msg);
}

FloorPlan floor_plan_from(const MapServerFile& file, const GreyImage& image) {
  FloorPlan plan;
  plan.width = image.width;
  plan.height = image.height;
  plan.cell_m = file.resolution_m;
  plan.plan_from_grid = file.origin;
  plan.cells.reserve(image.pixels.size());
  for (std::uint32_t row = image.height; row > 0; --row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      plan.cells.push_back(cell_of(file, image, std::size_t{row - 1} * image.width + column));
    }
  }
  return plan;
}

}  // namespace weft::formats
