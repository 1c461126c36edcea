#include "core/config/document.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace weft::config {
namespace {

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

constexpr std::size_t kLongestShown = 60;

std::string shorten(std::string text) {
  if (text.size() > kLongestShown) text = text.substr(0, kLongestShown) + "...";
  return text;
}

}  // namespace

void Table::Document::refuse(std::size_t line, const std::string& text) {
  const auto same = [&](const Issue& issue) { return issue.line == line && issue.text == text; };
  if (readable && std::none_of(issues.begin(), issues.end(), same)) issues.push_back({line, text});
}

void Table::Document::set(const std::string& path, std::string value, bool is_default) {
  const auto same = [&](const Setting& setting) { return setting.key == path; };
  if (std::none_of(settings.begin(), settings.end(), same)) settings.push_back({path, std::move(value), is_default});
}

std::string Table::Document::known(const std::string& path) const {
  const std::string before = path.empty() ? "" : path + ".";
  std::string names;
  for (auto each = asked.lower_bound(before); each != asked.end() && each->starts_with(before); ++each) {
    const std::string name = each->substr(before.size());
    if (is_bare(name)) names += (names.empty() ? "" : ", ") + name;
  }
  return names.empty() ? "" : "there are " + names + ": ";
}

void Table::Document::find_unknown(const toml::table& table, const std::string& path,
                                   std::vector<Issue>& found) const {
  for (const auto& [key, node] : table) {
    const std::string name = join_path(path, key.str());
    if (!asked.contains(name)) {
      found.push_back({line_of(node), name + ": unknown key; " + known(path) + "correct its spelling or remove it"});
    } else if (const toml::table* const inner = node.as_table()) {
      find_unknown(*inner, name, found);
    } else if (const toml::array* const entries = node.as_array()) {
      for (std::size_t i = 0; i < entries->size(); ++i) {
        const std::string entry = name + "[" + std::to_string(i) + "]";
        if (const toml::table* const each = (*entries)[i].as_table(); each != nullptr && asked.contains(entry)) {
          find_unknown(*each, entry, found);
        }
      }
    }
  }
}

std::string join_path(const std::string& path, std::string_view key) {
  const std::string name = is_bare(key) ? std::string(key) : "\"" + std::string(key) + "\"";
  return path.empty() ? name : path + "." + name;
}

std::size_t line_of(const toml::node& node) {
  return node.source().begin.line;
}

std::string show(bool value) {
  return value ? "true" : "false";
}

std::string show(std::int64_t value) {
  return std::to_string(value);
}

std::string show(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::string(text.data(), end) : "?";
}

std::string show(const std::string& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

std::string show(const toml::node& node) {
  if (node.is_table()) return "a table";
  std::ostringstream out;
  node.visit([&](const auto& typed) { out << typed; });
  return shorten(out.str());
}

}  // namespace weft::config
