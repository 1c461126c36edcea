#pragma once
#include <string_view>

struct dds_topic_descriptor;

namespace weft::bus::cyclonedds {

/// Returns the descriptor that idlc made of the type; null for a name that is not in idl/messages.
const dds_topic_descriptor* descriptor(std::string_view type);

}  // namespace weft::bus::cyclonedds
