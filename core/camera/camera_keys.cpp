#include "core/camera/camera_keys.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/camera/number_text.hpp"

namespace weft {

std::size_t CameraKeys::line_of(const YAML::Node& node) {
  return node.Mark().is_null() ? 1 : static_cast<std::size_t>(node.Mark().line) + 1;
}

CameraKeys::CameraKeys(const YAML::Node& map, std::string_view file) : file_(file), line_(line_of(map)) {
  if (!map.IsMap()) {
    wrong(map, "a list of 'key: value' is needed here");
    return;
  }
  std::set<std::string> seen;
  for (const auto& entry : map) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : std::string("(a key that is no word)");
    if (!seen.insert(key).second) wrong(entry.first, key + " stands there a second time");
    entries_.emplace_back(key, entry);
  }
}

bool CameraKeys::has(std::string_view key) const {
  return std::ranges::any_of(entries_, [&](const auto& entry) { return entry.first == key; });
}

std::optional<YAML::Node> CameraKeys::take(std::string_view key) {
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->first != key) continue;
    const YAML::Node value = entry->second.second;
    entries_.erase(entry);
    return value;
  }
  return std::nullopt;
}

std::optional<YAML::Node> CameraKeys::need(std::string_view key) {
  std::optional<YAML::Node> value = take(key);
  if (!value.has_value()) wrong(line_, "the key " + std::string(key) + " is missing");
  return value;
}

void CameraKeys::pass_over(std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) take(key);
}

std::string CameraKeys::word(std::string_view key) {
  const std::optional<YAML::Node> node = need(key);
  if (!node.has_value()) return {};
  if (node->IsScalar() && !node->Scalar().empty()) return node->Scalar();
  wrong(*node, std::string(key) + " must be a word");
  return {};
}

double CameraKeys::number(const YAML::Node& node, std::string_view key, double low, double high) {
  double value = 0.0;
  if (node.IsScalar()) {
    const std::string& text = node.Scalar();
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, problem] = std::from_chars(begin, text.data() + text.size(), value);
    if (problem == std::errc() && end == text.data() + text.size() && value >= low && value <= high) return value;
  }
  wrong(node, std::string(key) + ": " + (node.IsScalar() ? "'" + node.Scalar().substr(0, 40) + "'" : "this") +
                  " is no number in [" + number_text(low) + ", " + number_text(high) + "]");
  return low;
}

std::vector<double> CameraKeys::numbers(const YAML::Node& node, std::string_view key, std::size_t fewest,
                                        std::size_t most, double low, double high) {
  std::vector<double> values;
  if (!node.IsSequence() || node.size() < fewest || node.size() > most) {
    const std::string many =
        fewest == most ? std::to_string(fewest) : std::to_string(fewest) + " to " + std::to_string(most);
    wrong(node, std::string(key) + " must be a list of " + many + " numbers");
  } else {
    for (const YAML::Node& value : node) values.push_back(number(value, key, low, high));
  }
  values.resize(std::max(values.size(), fewest), low);
  return values;
}

void CameraKeys::wrong(std::size_t line, const std::string& what) {
  if (!ok()) return;
  error_ = {ErrorCode::invalid, std::string(file_) + ":" + std::to_string(line) + ": " + what};
}

void CameraKeys::adopt(const CameraKeys& part) {
  if (ok()) error_ = part.error_;
}

std::vector<std::string> CameraKeys::left_over() const {
  std::vector<std::string> names;
  for (const auto& [key, entry] : entries_)
    names.push_back(std::string(file_) + ":" + std::to_string(line_of(entry.first)) + ": " + key);
  return names;
}

}  // namespace weft
