#include <sodium/crypto_hash_sha256.h>

#include "core/network/codec.hpp"

namespace weft {

ContentHash hash_bytes(ByteView bytes) {
  static_assert(crypto_hash_sha256_BYTES == sizeof(ContentHash::bytes));
  ContentHash hash;
  crypto_hash_sha256(hash.bytes.data(), bytes.data(), bytes.size());
  return hash;
}

ContentHash hash(const Batch& batch) {
  return hash_bytes(encode(batch));
}

}  // namespace weft
