#include "idl/convert/reading.hpp"

namespace weft::convert {

void Reading::complain(std::string_view field, std::string_view bound) {
  Reading& top = root();
  if (top.error_) return;
  top.error_ = path() + "." + std::string(field) + " " + std::string(bound);
}

std::string Reading::text(std::string_view field, const std::string& value, std::size_t most) {
  if (value.size() > most) complain(field, "is longer than " + std::to_string(most) + " bytes");
  require(value.find('\0') == std::string::npos, field, "must not contain a zero byte");
  return value;
}

std::string Reading::path() const {
  if (parent_ != nullptr && name_.empty()) return parent_->path();
  std::string text = parent_ == nullptr ? std::string() : parent_->path() + ".";
  text += name_;
  if (index_) text += "[" + std::to_string(*index_) + "]";
  return text;
}

}  // namespace weft::convert
