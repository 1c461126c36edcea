#include "storage/sqlite/rows.hpp"

#include <zstd.h>

#include <algorithm>
#include <string>

#include "core/network/codec.hpp"
#include "core/protocol/messages.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kGuardBytes = 8;
constexpr std::size_t kLeastSaved = 8;  // an eighth: less is not worth decoding it at every reading
constexpr int kLevel = 1;               // descriptors and patches: level 3 gains about a percent for twice the time

}  // namespace

Bytes guard_row(Bytes canonical) {
  const ContentHash hash = hash_bytes(canonical);
  canonical.insert(canonical.end(), hash.bytes.begin(), hash.bytes.begin() + kGuardBytes);
  return canonical;
}

std::optional<ByteView> unguard_row(ByteView row) {
  if (row.size() < kGuardBytes) return std::nullopt;
  const ByteView canonical = row.first(row.size() - kGuardBytes);
  const ContentHash hash = hash_bytes(canonical);
  if (!std::equal(hash.bytes.begin(), hash.bytes.begin() + kGuardBytes, row.last(kGuardBytes).begin())) {
    return std::nullopt;
  }
  return canonical;
}

namespace {

/// Canonical clouds are on their lattice already, so nothing is lost; still no byte is given up on a codec's word.
/// None: no cloud, or one that it does not bring back.
std::optional<Bytes> compressed_cloud(ByteView content) {
  if (!clouds::is_cloud(content)) return std::nullopt;
  Result<Bytes> compressed = clouds::compress_cloud(content);
  if (!compressed || compressed->size() >= content.size()) return std::nullopt;
  const Result<Bytes> back = clouds::expand_cloud(*compressed);
  if (!back || !std::ranges::equal(*back, content)) return std::nullopt;
  return std::move(*compressed);
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
  Bytes bytes(ZSTD_compressBound(content.size()));
  const std::size_t size =
      ZSTD_compressCCtx(compressor_.get(), bytes.data(), bytes.size(), content.data(), content.size(), kLevel);
  if (ZSTD_isError(size) != 0 || size > content.size() - content.size() / kLeastSaved) return {};
  bytes.resize(size);
  return {Coding::zstd, std::move(bytes)};
}

Result<Bytes> ContentCoder::decode(Coding coding, ByteView stored, std::uint64_t size) {
  if (size > msg::kContentBytes) {
    return fail(ErrorCode::corrupt, "its row says " + std::to_string(size) + " bytes, the largest content has " +
                                        std::to_string(msg::kContentBytes));
  }
  if (coding == Coding::raw) return Bytes(stored.begin(), stored.end());
  if (coding == Coding::cloud) {
    Result<Bytes> cloud = clouds::expand_cloud(stored);
    if (!cloud || cloud->size() == size) return cloud;
    return fail(ErrorCode::corrupt,
                "it has " + std::to_string(cloud->size()) + " bytes, not " + std::to_string(size));
  }
  if (coding != Coding::zstd) {
    return fail(ErrorCode::corrupt, "unknown coding " + std::to_string(static_cast<std::uint64_t>(coding)));
  }
  Bytes bytes(size);
  const std::size_t got =
      ZSTD_decompressDCtx(decompressor_.get(), bytes.data(), bytes.size(), stored.data(), stored.size());
  if (ZSTD_isError(got) != 0) return fail(ErrorCode::corrupt, std::string("zstd: ") + ZSTD_getErrorName(got));
  if (got != size)
    return fail(ErrorCode::corrupt, "it has " + std::to_string(got) + " bytes, not " + std::to_string(size));
  return bytes;
}

}  // namespace weft::storage::sqlite
