#pragma once

namespace weft::bus::fastdds {

/// Sends what Fast DDS has to say to the process's stderr, from the first call on. Its default is stdout, which
/// carries the answers of programs: a line of it in between would make their JSON unreadable.
void write_diagnostics_to_stderr();

}  // namespace weft::bus::fastdds
