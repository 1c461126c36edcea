#include "storage/spool/file_names.hpp"

#include <charconv>
#include <system_error>

namespace weft::storage {

std::string numbered(std::uint64_t order, std::string_view ending) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string name(kFileDigits, '0');
  for (std::size_t at = kFileDigits; at-- > 0; order >>= 4U) name[at] = digits[order & 15U];
  return name.append(ending);
}

std::optional<std::uint64_t> number_of(std::string_view name, std::string_view ending) {
  if (name.size() != kFileDigits + ending.size() || !name.ends_with(ending)) return std::nullopt;
  std::uint64_t order = 0;
  const char* const end = name.data() + kFileDigits;
  const auto [rest, failed] = std::from_chars(name.data(), end, order, 16);
  if (failed != std::errc{} || rest != end) return std::nullopt;
  return order;
}

}  // namespace weft::storage
