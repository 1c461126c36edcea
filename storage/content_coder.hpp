#pragma once
#include <cstdint>
#include <memory>

#include "core/bytes.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

/// Codes contents as they stand in a store, and travel from it: docs/formats/store.md, column `coding`.
namespace weft::storage {

using msg::Coding;

struct Coded {
  Coding coding = Coding::raw;
  Bytes bytes;  ///< empty for raw: the content itself is kept
};

/// Keeps what zstd works in from one content to the next: making it anew takes half the time of a small one.
class ContentCoder {
 public:
  ContentCoder();
  /// Compresses, unless that saves less than an eighth. What comes back is the same to the byte, clouds included.
  Coded encode(ByteView content);
  /// Returns the content of `size` bytes; nothing larger is made, whatever `coded` says. Its hash is for the caller
  /// to verify. corrupt: the bytes do not decode to `size` bytes.
  Result<Bytes> decode(Coding coding, ByteView coded, std::uint64_t size);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
    void operator()(ZSTD_DCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> compressor_;
  std::unique_ptr<ZSTD_DCtx_s, Free> decompressor_;
};

}  // namespace weft::storage
