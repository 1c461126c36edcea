#pragma once
#include <string>

#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Return a file's bytes, unpacked if its name ends in .gz. invalid: it cannot be opened; exhausted: over 1 GiB,
/// packed or unpacked; corrupt: its gzip data is damaged, ends early, or is none. Nothing of such a file is returned;
/// each message names the file and what to do.
Result<Bytes> read_file(const std::string& file);
Result<std::string> read_text(const std::string& file);
/// Write a whole file. exhausted: it cannot be written.
Result<void> write_file(ByteView bytes, const std::string& file);
Result<void> write_file(const std::string& text, const std::string& file);

/// Returns the name's ending, lower case, with its dot, without .gz: ".g2o" for "A.G2O.gz"; empty if there is none.
std::string ending_of(const std::string& file);

}  // namespace weft::cli
