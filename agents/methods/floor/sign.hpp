#pragma once
#include <optional>

#include "agents/methods/floor/content.hpp"
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Returns the signature that `Floor::sign` gives, for whoever has contents and no camera.
std::optional<Signature> sign_floor_content(const FloorContent& content);

}  // namespace weft::agents
