#include "server/process/signers.hpp"

#include "agents/methods/all.hpp"

namespace weft::server {

Signers all_signers() {
  Signers signers;
  agents::AllMethods::for_each([&]<class M>() {
    if constexpr (agents::SignsBytes<M>) signers[{std::string(M::name), M::content_format}] = M::sign_bytes;
  });
  return signers;
}

}  // namespace weft::server
