#pragma once
#include <toml++/toml.h>
#include <set>
#include <string>
#include <vector>

#include "core/config/config.hpp"

/// Implements `Table`; private to this folder, so that toml++ stays out of everyone's compile.
namespace weft::config {

struct Issue {
  std::size_t line = 0;
  std::string text;
};

struct Table::Document {
  std::string file;
  toml::table root;
  bool readable = true;  ///< false: no TOML; nothing else is worth saying
  std::vector<Issue> issues;
  std::set<std::string> asked;
  std::vector<Setting> settings;

  /// Notes what is wrong, once however often a table is read.
  void refuse(std::size_t line, const std::string& text);
  /// Notes that the key is known; a setting is listed once.
  void ask(const std::string& path) { asked.insert(path); }
  void set(const std::string& path, std::string value, bool is_default);
  /// Returns the keys that were asked for in the table at `path`, in words; empty where there are none.
  std::string known(const std::string& path) const;
  /// Finds the keys of `table` and below that nobody asked for.
  void find_unknown(const toml::table& table, const std::string& path, std::vector<Issue>& found) const;
};

struct Table::Node {
  std::string path;                    ///< "" for the root
  const toml::table* table = nullptr;  ///< null: not in the file
  std::size_t line = 1;                ///< of the table, or of the one that should hold it
};

/// Returns "path.key", the key quoted where TOML would quote it.
std::string join_path(const std::string& path, std::string_view key);
std::size_t line_of(const toml::node& node);
std::string show(bool value);
std::string show(std::int64_t value);
std::string show(double value);
std::string show(const std::string& text);
std::string show(const toml::node& node);
template <class T>
std::string show(const std::vector<T>& values) {
  std::string text = "[";
  for (const T& value : values) text += (text.size() == 1 ? "" : ", ") + show(value);
  return text + "]";
}

}  // namespace weft::config
