#include "storage/spool/replacement.hpp"

#include <charconv>
#include <system_error>

#include "storage/spool/durable_file.hpp"

namespace weft::storage {
namespace {

constexpr std::size_t kDigits = 16;
constexpr std::string_view kHead = "weft-replace 1\n";
constexpr std::string_view kRemove = "remove ";
constexpr std::string_view kAdd = "add ";
constexpr std::string_view kEnd = "end\n";

/// Takes a line "<word><16 hex digits>" off the text; none: it begins otherwise.
std::optional<std::uint64_t> take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  const auto order = number_of(text.substr(word.size(), kDigits + 1), "\n");
  if (order) text.remove_prefix(word.size() + kDigits + 1);
  return order;
}

}  // namespace

std::string numbered(std::uint64_t order, std::string_view ending) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string name(kDigits, '0');
  for (std::size_t at = kDigits; at-- > 0; order >>= 4U) name[at] = digits[order & 15U];
  return name.append(ending);
}

std::optional<std::uint64_t> number_of(std::string_view name, std::string_view ending) {
  if (name.size() != kDigits + ending.size() || !name.ends_with(ending)) return std::nullopt;
  std::uint64_t order = 0;
  const char* const end = name.data() + kDigits;
  const auto [rest, failed] = std::from_chars(name.data(), end, order, 16);
  if (failed != std::errc{} || rest != end) return std::nullopt;
  return order;
}

Bytes encode(const Replacement& replacement) {
  std::string text(kHead);
  for (const std::uint64_t order : replacement.removed) text.append(kRemove).append(numbered(order, "\n"));
  for (const std::uint64_t order : replacement.added) text.append(kAdd).append(numbered(order, "\n"));
  text += kEnd;
  return {text.begin(), text.end()};
}

Result<Replacement> decode_replacement(ByteView bytes) {
  const std::string whole(bytes.begin(), bytes.end());
  std::string_view text = whole;
  if (!text.starts_with(kHead)) {
    return text.starts_with("weft-replace ") ? fail(ErrorCode::newer, "of a later format than 1")
                                             : fail(ErrorCode::corrupt, "does not begin with weft-replace 1");
  }
  text.remove_prefix(kHead.size());
  Replacement replacement;
  while (const auto order = take(text, kRemove)) replacement.removed.push_back(*order);
  while (const auto order = take(text, kAdd)) replacement.added.push_back(*order);
  if (text != kEnd) return fail(ErrorCode::corrupt, "not understood after the files that it names");
  return replacement;
}

Result<void> carry_out(const std::filesystem::path& directory, const Replacement& replacement) {
  for (const std::uint64_t order : replacement.added) {
    const std::filesystem::path staged = directory / numbered(order, kStagedEnding);
    if (auto done = rename_if_there(staged, directory / numbered(order, kBatchEnding)); !done) return done;
  }
  for (const std::uint64_t order : replacement.removed)
    if (auto done = remove_durably(directory / numbered(order, kBatchEnding)); !done) return done;
  return remove_durably(directory / kReplacementFile);
}

}  // namespace weft::storage
