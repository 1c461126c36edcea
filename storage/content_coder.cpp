#include "storage/content_coder.hpp"

#include <zstd.h>

#include <algorithm>
#include <optional>
#include <string>

#include "storage/clouds/cloud.hpp"

namespace weft::storage {
namespace {

constexpr std::size_t kLeastSaved = 8;  // an eighth: less is not worth decoding it at every reading
constexpr int kLevel = 1;               // descriptors and patches: level 3 gains about a percent for twice the time

/// Compresses a canonical cloud. It is on its lattice already, so nothing is lost; still what comes back is compared
/// with it. None: no cloud, one that does not get smaller, or one that does not come back the same.
std::optional<Bytes> compressed_cloud(ByteView content) {
  if (!clouds::is_cloud(content)) return std::nullopt;
  Result<Bytes> compressed = clouds::compress_cloud(content);
  if (!compressed || compressed->size() >= content.size()) return std::nullopt;
  const Result<Bytes> back = clouds::expand_cloud(*compressed);
  if (!back || !std::ranges::equal(*back, content)) return std::nullopt;
  return std::move(*compressed);
}

tl::unexpected<Error> wrong_size(std::uint64_t got, std::uint64_t size) {
  return fail(ErrorCode::corrupt, "it has " + std::to_string(got) + " bytes, not " + std::to_string(size));
}

Result<Bytes> cloud_of_size(ByteView compressed, std::uint64_t size) {
  const Result<std::uint64_t> stated = clouds::expanded_size(compressed);
  if (!stated) return fail(stated.error());
  if (*stated != size) return wrong_size(*stated, size);
  return clouds::expand_cloud(compressed);
}

}  // namespace

void ContentCoder::Free::operator()(ZSTD_CCtx_s* context) const {
  ZSTD_freeCCtx(context);
}
void ContentCoder::Free::operator()(ZSTD_DCtx_s* context) const {
  ZSTD_freeDCtx(context);
}

ContentCoder::ContentCoder() : compressor_(ZSTD_createCCtx()), decompressor_(ZSTD_createDCtx()) {}

Coded ContentCoder::encode(ByteView content) {
  if (auto cloud = compressed_cloud(content)) return {Coding::cloud, std::move(*cloud)};
  const std::size_t room = ZSTD_compressBound(content.size());
  const auto frame = std::make_unique_for_overwrite<std::uint8_t[]>(room);
  const std::size_t size =
      ZSTD_compressCCtx(compressor_.get(), frame.get(), room, content.data(), content.size(), kLevel);
  if (ZSTD_isError(size) != 0 || size > content.size() - content.size() / kLeastSaved) return {};
  return {Coding::zstd, Bytes(frame.get(), frame.get() + size)};
}

Result<Bytes> ContentCoder::decode(Coding coding, ByteView coded, std::uint64_t size) {
  if (size > msg::kContentBytes) {
    return fail(ErrorCode::corrupt, "it should have " + std::to_string(size) + " bytes, the largest content has " +
                                        std::to_string(msg::kContentBytes));
  }
  switch (coding) {
    case Coding::raw:
      if (coded.size() != size) return wrong_size(coded.size(), size);
      return Bytes(coded.begin(), coded.end());
    case Coding::cloud:
      return cloud_of_size(coded, size);
    case Coding::zstd:
      break;
    default:
      return fail(ErrorCode::corrupt, "unknown coding " + std::to_string(static_cast<unsigned>(coding)));
  }
  Bytes bytes(size);
  const std::size_t got =
      ZSTD_decompressDCtx(decompressor_.get(), bytes.data(), bytes.size(), coded.data(), coded.size());
  if (ZSTD_isError(got) != 0) return fail(ErrorCode::corrupt, std::string("zstd: ") + ZSTD_getErrorName(got));
  if (got != size) return wrong_size(got, size);
  return bytes;
}

}  // namespace weft::storage
