#pragma once
#include "server/base/signers.hpp"

namespace weft::server {

/// Returns the signers of every method whose contents this server can sign; chosen here and nowhere else.
Signers all_signers();

}  // namespace weft::server
