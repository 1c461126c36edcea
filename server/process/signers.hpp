#pragma once
#include "server/base/signers.hpp"

namespace weft::server {

/// Every method whose contents this server can sign; chosen here and nowhere else.
Signers all_signers();

}  // namespace weft::server
