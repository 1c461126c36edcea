#pragma once
#include <cstddef>
#include <vector>

#include "core/network/window.hpp"

namespace weft::server {

/// Cuts a patch into parts of at most `entities` places, edges, labels and removals each; all of them share base,
/// target and digest. A patch without any entity is one empty part.
std::vector<Patch> parts_of(const Patch& patch, std::size_t entities);

}  // namespace weft::server
