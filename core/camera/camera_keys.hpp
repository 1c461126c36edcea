#pragma once
// Private to core/camera: the keys of a YAML document, each taken once.
#include <yaml-cpp/yaml.h>

#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.hpp"

namespace weft {

/// Takes the keys of a YAML map. Keeps the first error; values read after it mean nothing, so ask `ok` at the end.
class CameraKeys {
 public:
  CameraKeys(const YAML::Node& map, std::string_view file);

  bool has(std::string_view key) const;
  /// Takes the value of a key, which is then no longer left over.
  std::optional<YAML::Node> take(std::string_view key);
  std::optional<YAML::Node> need(std::string_view key);
  /// Marks these keys as known; whatever they hold needs no reading.
  void pass_over(std::initializer_list<std::string_view> keys);
  std::string word(std::string_view key);
  double number(const YAML::Node& node, std::string_view key, double low, double high);
  /// Reads a list of between `fewest` and `most` numbers within the bounds.
  std::vector<double> numbers(const YAML::Node& node, std::string_view key, std::size_t fewest, std::size_t most,
                              double low, double high);

  void wrong(const YAML::Node& node, const std::string& what) { wrong(line_of(node), what); }
  void wrong(std::size_t line, const std::string& what);
  /// Takes over what went wrong in a part of this document.
  void adopt(const CameraKeys& part);
  bool ok() const { return error_.message.empty(); }
  const Error& error() const { return error_; }
  /// Returns "file:line: key" of each key that nobody took.
  std::vector<std::string> left_over() const;
  std::string_view file() const { return file_; }
  static std::size_t line_of(const YAML::Node& node);

 private:
  // A list, because assigning a YAML::Node changes the document behind it.
  std::list<std::pair<std::string, std::pair<YAML::Node, YAML::Node>>> entries_;
  std::string_view file_;
  std::size_t line_ = 1;
  Error error_;
};

}  // namespace weft
