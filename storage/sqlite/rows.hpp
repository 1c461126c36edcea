#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "core/bytes.hpp"
#include "core/result.hpp"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

/// How rows and contents stand in the columns of the store; docs/formats/store.md.
namespace weft::storage::sqlite {

/// Canonical bytes followed by the first 8 bytes of their SHA-256, so that a flipped bit is seen.
Bytes guard_row(Bytes canonical);
/// The canonical bytes; none when the row is damaged.
std::optional<ByteView> unguard_row(ByteView row);

enum class Coding : std::uint64_t { raw = 0, zstd = 1, cloud = 2 };

struct Coded {
  Coding coding = Coding::raw;
  Bytes bytes;  ///< empty for raw: the content itself is stored
};

/// Keeps what zstd works in from one content to the next: making it anew takes half the time of a small one.
class ContentCoder {
 public:
  ContentCoder();
  /// Compressed, unless that saves less than an eighth. What comes back is the same to the byte, clouds included.
  Coded encode(ByteView content);
  /// corrupt: the bytes do not decode to `size` bytes.
  Result<Bytes> decode(Coding coding, ByteView stored, std::uint64_t size);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
    void operator()(ZSTD_DCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> compressor_;
  std::unique_ptr<ZSTD_DCtx_s, Free> decompressor_;
};

}  // namespace weft::storage::sqlite
