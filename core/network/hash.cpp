#include <nettle/sha2.h>

#include "core/network/codec.hpp"

namespace weft {

ContentHash hash_bytes(ByteView bytes) {
  static_assert(SHA256_DIGEST_SIZE == sizeof(ContentHash::bytes));
  ContentHash hash;
  sha256_ctx state{};
  sha256_init(&state);
  sha256_update(&state, bytes.size(), bytes.data());
  sha256_digest(&state, hash.bytes.size(), hash.bytes.data());
  return hash;
}

ContentHash hash(const Batch& batch) {
  return hash_bytes(encode(batch));
}

}  // namespace weft
