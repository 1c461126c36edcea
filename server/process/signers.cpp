#include "server/process/signers.hpp"

#include "agents/methods/floor/content.hpp"
#include "agents/methods/floor/sign.hpp"

namespace weft::server {
namespace {

std::optional<agents::Signature> sign_floor(ByteView bytes) {
  const Result<agents::FloorContent> content = agents::decode_floor_content(bytes);
  if (!content) return std::nullopt;
  return agents::sign_floor_content(*content);
}

}  // namespace

Signers all_signers() {
  return {{{"floor", agents::floor_content_format}, sign_floor}};
}

}  // namespace weft::server
