#pragma once
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::formats {

/// Holds one file of an archive.
struct TarMember {
  std::string name;  ///< with "/" between folders; up to 100 bytes
  std::string text;
};

/// Returns the archive (POSIX ustar) that has these files, readable by all, of that time. invalid: a name is empty or
/// longer than 100 bytes; names it.
Result<Bytes> tar_of(const std::vector<TarMember>& members, WallTime at);

}  // namespace weft::formats
