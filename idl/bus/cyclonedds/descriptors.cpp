#include "idl/bus/cyclonedds/descriptors.hpp"

#include <dds/dds.h>

#include <array>

// idlc's headers have the same names as fastddsgen's and are on no include path.
extern "C" {
extern const dds_topic_descriptor_t weft_idl_Hello_desc, weft_idl_RobotDescription_desc, weft_idl_RobotState_desc,
    weft_idl_ExperienceBatch_desc, weft_idl_BatchAck_desc, weft_idl_Chunk_desc, weft_idl_ContentRequest_desc,
    weft_idl_WindowRequest_desc, weft_idl_WindowPatch_desc, weft_idl_RouteOrder_desc, weft_idl_RouteProgress_desc,
    weft_idl_AgentCommand_desc, weft_idl_AgentReply_desc, weft_idl_OperatorRequest_desc, weft_idl_OperatorReply_desc,
    weft_idl_Query_desc, weft_idl_QueryReply_desc, weft_idl_EventNote_desc, weft_idl_ClockProbe_desc,
    weft_idl_ClockReply_desc, weft_idl_Recognise_desc, weft_idl_Recognised_desc;
}

namespace weft::bus::cyclonedds {

const dds_topic_descriptor* descriptor(std::string_view type) {
  static constexpr std::array kAll = {
      &weft_idl_Hello_desc,           &weft_idl_RobotDescription_desc, &weft_idl_RobotState_desc,
      &weft_idl_ExperienceBatch_desc, &weft_idl_BatchAck_desc,         &weft_idl_Chunk_desc,
      &weft_idl_ContentRequest_desc,  &weft_idl_WindowRequest_desc,    &weft_idl_WindowPatch_desc,
      &weft_idl_RouteOrder_desc,      &weft_idl_RouteProgress_desc,    &weft_idl_AgentCommand_desc,
      &weft_idl_AgentReply_desc,      &weft_idl_OperatorRequest_desc,  &weft_idl_OperatorReply_desc,
      &weft_idl_Query_desc,           &weft_idl_QueryReply_desc,       &weft_idl_EventNote_desc,
      &weft_idl_ClockProbe_desc,      &weft_idl_ClockReply_desc,       &weft_idl_Recognise_desc,
      &weft_idl_Recognised_desc};
  for (const dds_topic_descriptor_t* const candidate : kAll) {
    if (type == candidate->m_typename) return candidate;
  }
  return nullptr;
}

}  // namespace weft::bus::cyclonedds
