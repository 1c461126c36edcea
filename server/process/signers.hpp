#pragma once
#include "server/base/signers.hpp"

namespace weft::server {

/// Returns the signers of every method of agents/methods/all.hpp whose contents can be signed without a camera.
Signers all_signers();

}  // namespace weft::server
