#include "core/ids.hpp"

#include <charconv>

namespace weft {
namespace {

constexpr std::size_t kExperienceDigits = 16;

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

bool parse_hex(std::string_view text, std::uint8_t* out, std::size_t size) {
  if (text.size() != 2 * size) return false;
  for (const char c : text) {
    if (hex_digit(c) < 0) return false;
  }
  for (std::size_t i = 0; i < size; ++i) {
    out[i] = static_cast<std::uint8_t>(hex_digit(text[2 * i]) * 16 + hex_digit(text[2 * i + 1]));
  }
  return true;
}

std::string to_string(ExperienceId id) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text(kExperienceDigits, '0');
  for (std::size_t i = 0; i < kExperienceDigits; ++i) text[i] = digits[(id.value >> (60U - 4U * i)) & 15U];
  return text;
}

std::string to_string(const PlaceId& id) {
  return to_string(id.experience) + ":" + std::to_string(id.index);
}

std::optional<ExperienceId> parse_experience_id(std::string_view text) {
  std::array<std::uint8_t, kExperienceDigits / 2> bytes{};
  if (!parse_hex(text, bytes.data(), bytes.size())) return std::nullopt;
  ExperienceId id;
  for (const std::uint8_t byte : bytes) id.value = (id.value << 8U) | byte;
  return id;
}

std::optional<PlaceId> parse_place_id(std::string_view text) {
  if (text.size() < kExperienceDigits + 2 || text[kExperienceDigits] != ':') return std::nullopt;
  const auto experience = parse_experience_id(text.substr(0, kExperienceDigits));
  if (!experience) return std::nullopt;
  PlaceId id{*experience, 0};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data() + kExperienceDigits + 1, end, id.index);
  if (error != std::errc{} || stopped != end) return std::nullopt;
  return id;
}

}  // namespace weft
