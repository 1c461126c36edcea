#include "core/config/config.hpp"

#include <algorithm>

#include "core/config/document.hpp"
#include "core/text.hpp"

namespace weft::config {

Table::Table(std::shared_ptr<Document> document, std::shared_ptr<const Node> node)
    : document_(std::move(document)), node_(std::move(node)) {}

Table parse(std::string_view text, std::string file) {
  auto document = std::make_shared<Table::Document>();
  document->file = std::move(file);
  try {
    document->root = toml::parse(without_byte_order_mark(text), document->file);
  } catch (const toml::parse_error& error) {
    document->refuse(error.source().begin.line, "no TOML: " + std::string(error.description()));
    document->readable = false;
  }
  const toml::table* const root = &document->root;
  return {std::move(document), std::make_shared<const Table::Node>(Table::Node{"", root, 1})};
}

bool Table::has(std::string_view key) const {
  return node_->table != nullptr && node_->table->contains(key);
}

Table Table::table(std::string_view key) const {
  Node inner{join_path(node_->path, key), nullptr, node_->line};
  document_->ask(inner.path);
  if (const toml::node* const found = node_->table == nullptr ? nullptr : node_->table->get(key)) {
    inner.line = line_of(*found);
    inner.table = found->as_table();
    if (inner.table == nullptr) {
      document_->refuse(inner.line,
                        inner.path + " = " + show(*found) + ": must be a table, write [" + inner.path + "]");
    }
  }
  return {document_, std::make_shared<const Node>(std::move(inner))};
}

std::vector<Table> Table::tables(std::string_view key, std::size_t fewest, std::size_t most) const {
  const std::string path = join_path(node_->path, key);
  document_->ask(path);
  std::vector<Table> entries;
  std::size_t line = node_->line;
  if (const toml::node* const found = node_->table == nullptr ? nullptr : node_->table->get(key)) {
    line = line_of(*found);
    const toml::array* const array = found->as_array();
    if (array == nullptr || !(array->empty() || array->is_homogeneous(toml::node_type::table))) {
      document_->refuse(line, path + " = " + show(*found) + ": must be an array of tables, write [[" + path + "]]");
      return {};
    }
    entries.reserve(array->size());
    for (std::size_t i = 0; i < array->size(); ++i) {
      Node entry{path + "[" + std::to_string(i) + "]", (*array)[i].as_table(), line_of((*array)[i])};
      document_->ask(entry.path);
      entries.push_back(Table(document_, std::make_shared<const Node>(std::move(entry))));
    }
  }
  if (entries.size() < fewest || entries.size() > most) {
    document_->refuse(line, path + ": has " + std::to_string(entries.size()) + " entries, must have " +
                                std::to_string(fewest) + " to " + std::to_string(most));
  }
  return entries;
}

void Table::refuse(std::string_view key, std::string_view message) const {
  const toml::node* const found = node_->table == nullptr ? nullptr : node_->table->get(key);
  const std::string value = found == nullptr ? "" : " = " + show(*found);
  document_->refuse(found == nullptr ? node_->line : line_of(*found),
                    join_path(node_->path, key) + value + ": " + std::string(message));
}

std::vector<std::string> Table::issues() const {
  std::vector<Issue> all = document_->issues;
  if (document_->readable) document_->find_unknown(document_->root, "", all);
  std::stable_sort(all.begin(), all.end(), [](const Issue& a, const Issue& b) { return a.line < b.line; });
  std::vector<std::string> texts;
  texts.reserve(all.size());
  for (const Issue& issue : all) {
    texts.push_back(document_->file + ":" + std::to_string(issue.line) + ": " + issue.text);
  }
  return texts;
}

Result<void> Table::result() const {
  std::string message;
  for (const std::string& issue : issues()) message += (message.empty() ? "" : "\n") + issue;
  if (message.empty()) return {};
  return fail(ErrorCode::invalid, message);
}

std::vector<Setting> Table::effective() const {
  return document_->settings;
}

std::string to_text(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& setting : settings) {
    text += (setting.is_default ? "  " : "* ") + setting.key + " = " + setting.value + "\n";
  }
  return text;
}

}  // namespace weft::config
