#include "idl/convert/reading.hpp"

namespace weft::convert {

void Reading::text(std::string_view field, std::string& value, const std::string& wire, std::size_t most) {
  value = wire;
  if (value.size() > most) complain(field, "is longer than " + std::to_string(most) + " bytes");
  require(value.find('\0') == std::string::npos, field, "must not contain a zero byte");
}

void Reading::texts(std::string_view field, std::vector<std::string>& values, const std::vector<std::string>& wire,
                    std::size_t most, std::size_t longest) {
  const std::size_t size = entries(field, values, wire, most);
  for (std::size_t i = 0; i < size; ++i) text(field, values[i], wire[i], longest);
}

void Reading::require_at_most(std::uint64_t number, std::uint64_t most, std::string_view field,
                              std::string_view unit) {
  if (number > most) complain(field, "must be at most " + std::to_string(most) + std::string(unit));
}

void Reading::complain(std::string_view field, std::string_view bound) {
  Reading& top = root();
  if (top.error_) return;
  top.error_ = path() + "." + std::string(field) + " " + std::string(bound);
}

bool Reading::has_at_most(std::string_view field, std::size_t size, std::size_t most) {
  if (size > most) complain(field, "has more than " + std::to_string(most) + " entries");
  return size <= most;
}

void Reading::complain_of_range(std::string_view field, std::uint64_t least, std::uint64_t most) {
  complain(field, "must be from " + std::to_string(least) + " to " + std::to_string(most));
}

std::string Reading::path() const {
  if (parent_ == nullptr) return std::string(name_);
  std::string text = parent_->path() + "." + std::string(name_);
  if (index_) text += "[" + std::to_string(*index_) + "]";
  return text;
}

}  // namespace weft::convert
