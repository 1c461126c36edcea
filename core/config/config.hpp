#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"

/// Reads and checks configuration in TOML. A program asks for each key it knows, with default and bounds; all that is
/// wrong is collected, and a key that nobody asked for is wrong. Nothing is substituted silently: a program that
/// finds issues refuses to start. Core parses text; whoever calls reads the file.
namespace weft::config {

/// Stands in the place of a default: the key must be there.
inline constexpr std::nullopt_t required = std::nullopt;

/// Describes one setting in force, for the log.
struct Setting {
  std::string key;    ///< whole path, e.g. "camera.mount.height_m", "walls[2].to"
  std::string value;  ///< as TOML would write it
  bool is_default = true;
};

/// Reads a table of a parsed document. It is a handle: copies and sub-tables report into the same document. Every
/// getter but `tables` returns a value within its bounds: the file's, or else the default (or, where the key is
/// required, the low bound, an empty text, the fewest entries) together with an issue.
class Table {
 public:
  /// Returns whether the key is written in the file; does not count as asking for it.
  bool has(std::string_view key) const;

  /// Returns any TOML integer or float that is finite and lies in [low, high].
  double number(std::string_view key, std::optional<double> fallback, double low, double high) const;
  std::int64_t integer(std::string_view key, std::optional<std::int64_t> fallback, std::int64_t low,
                       std::int64_t high) const;
  bool boolean(std::string_view key, std::optional<bool> fallback) const;
  /// Returns a text of at most `longest` bytes.
  std::string text(std::string_view key, const std::optional<std::string>& fallback, std::size_t longest = 256) const;
  /// Returns one of `allowed`, which is not empty; where the key is required and missing, the first of them.
  std::string choice(std::string_view key, const std::optional<std::string>& fallback,
                     const std::vector<std::string>& allowed) const;
  /// Returns between `fewest` and `most` numbers, each in [low, high].
  std::vector<double> numbers(std::string_view key, const std::optional<std::vector<double>>& fallback,
                              std::size_t fewest, std::size_t most, double low, double high) const;
  std::vector<std::string> texts(std::string_view key, const std::optional<std::vector<std::string>>& fallback,
                                 std::size_t fewest, std::size_t most, std::size_t longest = 256) const;
  /// Returns a sub-table; one that is not there is empty, so that its defaults hold and its required keys are missed.
  Table table(std::string_view key) const;
  /// Returns all entries of an array of tables, none when it is missing; not between `fewest` and `most` is an issue.
  std::vector<Table> tables(std::string_view key, std::size_t fewest, std::size_t most) const;

  /// Adds an issue of the caller's own about this key: what contradicts what, and what to do.
  void refuse(std::string_view key, std::string_view message) const;

  /// Returns all that is wrong in the whole document, by line: "FILE:LINE: KEY ...". Ask after all keys were read.
  std::vector<std::string> issues() const;
  /// Returns an error when there are issues. invalid: all of them, one a line.
  Result<void> result() const;
  /// Returns all settings that were asked for, in the order of asking.
  std::vector<Setting> effective() const;

 private:
  struct Document;
  struct Node;
  friend Table parse(std::string_view text, std::string file);
  Table(std::shared_ptr<Document> document, std::shared_ptr<const Node> node);

  std::shared_ptr<Document> document_;
  std::shared_ptr<const Node> node_;
};

/// Returns the document's root. `file` is for messages. Text that is no TOML becomes an issue like others.
Table parse(std::string_view text, std::string file);

/// Writes one line a setting, "key = value", those that differ from the default marked with "*".
std::string to_text(const std::vector<Setting>& settings);

}  // namespace weft::config
