#include "storage/spool/replacement.hpp"

#include <optional>
#include <string>
#include <string_view>

#include "storage/spool/durable_file.hpp"

namespace weft::storage {
namespace {

constexpr std::string_view kReplacementHead = "weft-replace 1\n";
constexpr std::string_view kRemovedLine = "remove ";
constexpr std::string_view kAddedLine = "add ";
constexpr std::string_view kReplacementEnd = "end\n";

/// Takes a line "<word><16 hex digits>" off the text; none: it begins otherwise.
std::optional<std::uint64_t> take_order(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return std::nullopt;
  const auto order = number_of(text.substr(word.size(), kFileDigits + 1), "\n");
  if (order) text.remove_prefix(word.size() + kFileDigits + 1);
  return order;
}

}  // namespace

Bytes encode(const Replacement& replacement) {
  std::string text(kReplacementHead);
  for (const std::uint64_t order : replacement.removed) text.append(kRemovedLine).append(numbered(order, "\n"));
  for (const std::uint64_t order : replacement.added) text.append(kAddedLine).append(numbered(order, "\n"));
  text += kReplacementEnd;
  return {text.begin(), text.end()};
}

Result<Replacement> decode_replacement(ByteView bytes) {
  const std::string whole(bytes.begin(), bytes.end());
  std::string_view text = whole;
  if (!text.starts_with(kReplacementHead)) {
    return text.starts_with("weft-replace ") ? fail(ErrorCode::newer, "of a later format than 1")
                                             : fail(ErrorCode::corrupt, "does not begin with weft-replace 1");
  }
  text.remove_prefix(kReplacementHead.size());
  Replacement replacement;
  while (const auto order = take_order(text, kRemovedLine)) replacement.removed.push_back(*order);
  while (const auto order = take_order(text, kAddedLine)) replacement.added.push_back(*order);
  if (text != kReplacementEnd) return fail(ErrorCode::corrupt, "not understood after the files that it names");
  return replacement;
}

Result<void> carry_out(const std::filesystem::path& directory, const Replacement& replacement) {
  for (const std::uint64_t order : replacement.added) {
    const std::filesystem::path staged = directory / numbered(order, kStagedEnding);
    if (auto done = rename_if_there(staged, directory / numbered(order, kBatchEnding)); !done) return done;
  }
  for (const std::uint64_t order : replacement.removed)
    if (auto done = remove_if_there(directory / numbered(order, kBatchEnding)); !done) return done;
  if (auto done = make_durable(directory, {}); !done) return done;
  return remove_durably(directory / kReplacementFile);
}

}  // namespace weft::storage
