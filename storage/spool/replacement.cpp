#include "storage/spool/replacement.hpp"

#include <optional>
#include <string>
#include <string_view>

#include "storage/spool/durable_file.hpp"

namespace weft::storage {
namespace {

constexpr std::string_view kHead = "weft-replace 1\n";
constexpr std::string_view kRemove = "remove ";
constexpr std::string_view kAdd = "add ";
constexpr std::string_view kEnd = "end\n";

/// Takes a line "<word><16 hex digits>" off the text; none: it begins otherwise.
std::optional<std::uint64_t> take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  const auto order = number_of(text.substr(word.size(), kFileDigits + 1), "\n");
  if (order) text.remove_prefix(word.size() + kFileDigits + 1);
  return order;
}

}  // namespace

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
