#include <algorithm>

#include "core/config/document.hpp"

namespace weft::config {
namespace {

template <class T>
std::string bounds(const T& low, const T& high) {
  return "must be in [" + show(low) + ", " + show(high) + "]";
}

std::optional<double> read_number(const toml::node& node) {
  if (const auto* const real = node.as_floating_point()) return real->get();
  if (const auto* const whole = node.as_integer()) return static_cast<double>(whole->get());
  return std::nullopt;
}

/// Holds the result of a getter: a value, or what is wrong with it.
template <class T>
struct Found {
  std::optional<T> value;
  std::string wrong;
};

/// Reads every entry; the first wrong one is named by its position.
template <class T, class ReadEntry>
Found<std::vector<T>> read_array(const toml::node& node, std::size_t fewest, std::size_t most, const char* kind,
                                 ReadEntry&& read_entry) {
  const toml::array* const array = node.as_array();
  if (array == nullptr) return {std::nullopt, std::string("must be an array of ") + kind};
  if (array->size() < fewest || array->size() > most) {
    return {std::nullopt, "has " + std::to_string(array->size()) + " entries, must have " + std::to_string(fewest) +
                              " to " + std::to_string(most)};
  }
  std::vector<T> values;
  for (std::size_t i = 0; i < array->size(); ++i) {
    Found<T> entry = read_entry((*array)[i]);
    if (!entry.value) return {std::nullopt, "entry " + std::to_string(i) + " " + entry.wrong};
    values.push_back(std::move(*entry.value));
  }
  return {std::move(values), {}};
}

Found<double> bounded_number(const toml::node& node, double low, double high) {
  const std::optional<double> value = read_number(node);
  if (!value) return {std::nullopt, "must be a number in [" + show(low) + ", " + show(high) + "]"};
  if (!(*value >= low && *value <= high)) return {std::nullopt, bounds(low, high)};
  return {value, {}};
}

Found<std::string> bounded_text(const toml::node& node, std::size_t longest) {
  const auto* const text = node.as_string();
  if (text == nullptr) return {std::nullopt, "must be a text in quotes"};
  if (text->get().size() > longest) {
    return {std::nullopt, "has " + std::to_string(text->get().size()) + " bytes, at most " + std::to_string(longest) +
                              " are allowed"};
  }
  return {text->get(), {}};
}

/// Does what all getters have in common: finds the key, reads it, notes what is wrong, lists the setting.
template <class Document, class Node, class T, class Read>
T get(Document& document, const Node& table, std::string_view key, const std::optional<T>& fallback, T if_missing,
      Read&& read) {
  const std::string path = join_path(table.path, key);
  document.ask(path);
  const toml::node* const node = table.table == nullptr ? nullptr : table.table->get(key);
  std::optional<T> written;
  if (node != nullptr) {
    Found<T> found = read(*node);
    if (!found.value) document.refuse(line_of(*node), path + " = " + show(*node) + ": " + found.wrong);
    written = std::move(found.value);
  } else if (!fallback) {
    document.refuse(table.line, path + ": is missing; it has no default, write it");
  }
  T value = written ? *written : fallback.value_or(std::move(if_missing));
  document.set(path, show(value), !written || (fallback && *fallback == value));
  return value;
}

}  // namespace

double Table::number(std::string_view key, std::optional<double> fallback, double low, double high) const {
  return get<Document, Node, double>(*document_, *node_, key, fallback, low,
                                     [&](const toml::node& node) { return bounded_number(node, low, high); });
}

std::int64_t Table::integer(std::string_view key, std::optional<std::int64_t> fallback, std::int64_t low,
                            std::int64_t high) const {
  return get<Document, Node, std::int64_t>(
      *document_, *node_, key, fallback, low, [&](const toml::node& node) -> Found<std::int64_t> {
        const auto* const value = node.as_integer();
        if (value == nullptr)
          return {std::nullopt, "must be a whole number in [" + show(low) + ", " + show(high) + "]"};
        if (value->get() < low || value->get() > high) {
          return {std::nullopt, "must be in [" + show(low) + ", " + show(high) + "]"};
        }
        return {value->get(), {}};
      });
}

bool Table::boolean(std::string_view key, std::optional<bool> fallback) const {
  return get<Document, Node, bool>(*document_, *node_, key, fallback, false,
                                   [](const toml::node& node) -> Found<bool> {
                                     const auto* const value = node.as_boolean();
                                     if (value == nullptr) return {std::nullopt, "must be true or false"};
                                     return {value->get(), {}};
                                   });
}

std::string Table::text(std::string_view key, const std::optional<std::string>& fallback, std::size_t longest) const {
  return get<Document, Node, std::string>(*document_, *node_, key, fallback, "",
                                          [&](const toml::node& node) { return bounded_text(node, longest); });
}

std::string Table::choice(std::string_view key, const std::optional<std::string>& fallback,
                          const std::vector<std::string>& allowed) const {
  const auto read = [&](const toml::node& node) -> Found<std::string> {
    const auto* const text = node.as_string();
    if (text != nullptr && std::find(allowed.begin(), allowed.end(), text->get()) != allowed.end()) {
      return {text->get(), {}};
    }
    std::string list;
    for (const std::string& each : allowed) list += (list.empty() ? "" : ", ") + show(each);
    return {std::nullopt, "must be one of " + list};
  };
  return get<Document, Node, std::string>(*document_, *node_, key, fallback, allowed.empty() ? "" : allowed.front(),
                                          read);
}

std::vector<double> Table::numbers(std::string_view key, const std::optional<std::vector<double>>& fallback,
                                   std::size_t fewest, std::size_t most, double low, double high) const {
  return get<Document, Node, std::vector<double>>(
      *document_, *node_, key, fallback, std::vector<double>(fewest, low), [&](const toml::node& node) {
        return read_array<double>(node, fewest, most, "numbers",
                                  [&](const toml::node& entry) { return bounded_number(entry, low, high); });
      });
}

std::vector<std::string> Table::texts(std::string_view key, const std::optional<std::vector<std::string>>& fallback,
                                      std::size_t fewest, std::size_t most, std::size_t longest) const {
  return get<Document, Node, std::vector<std::string>>(
      *document_, *node_, key, fallback, std::vector<std::string>(fewest), [&](const toml::node& node) {
        return read_array<std::string>(node, fewest, most, "texts",
                                       [&](const toml::node& entry) { return bounded_text(entry, longest); });
      });
}

}  // namespace weft::config
