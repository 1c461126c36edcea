#include "idl/bus/cyclonedds/descriptors.hpp"

#include <dds/dds.h>

// idlc's headers have the same names as fastddsgen's and are on no include path.
extern "C" {
#define WEFT_TOPIC(Id, Name, ...) extern const dds_topic_descriptor_t weft_idl_##Name##_desc;
#include "idl/bus/message_list.hpp"
}

namespace weft::bus::cyclonedds {

const dds_topic_descriptor* descriptor(std::string_view type) {
  static constexpr const dds_topic_descriptor_t* kAll[] = {
#define WEFT_TOPIC(Id, Name, ...) &weft_idl_##Name##_desc,
#include "idl/bus/message_list.hpp"
  };
  for (const dds_topic_descriptor_t* const candidate : kAll) {
    if (type == candidate->m_typename) return candidate;
  }
  return nullptr;
}

}  // namespace weft::bus::cyclonedds
