#include "idl/bus/fastdds/bytes_type.hpp"

#include <cstring>
#include <string>

#include "idl/bus/padding.hpp"

namespace weft::bus::fastdds {
namespace {
constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kKey = 16;
}  // namespace

BytesType::BytesType(const Topic& topic, Inbox& inbox) : topic_(topic), inbox_(inbox) {
  setName(std::string(topic.type).c_str());
  constexpr std::uint32_t kFirstAllocation = 256;  // grows with each message
  m_typeSize = kFirstAllocation;
  m_isGetKeyDefined = topic.keyed;
  auto_fill_type_object(false);
  auto_fill_type_information(false);
}

bool BytesType::serialize(void* sample, eprosima::fastrtps::rtps::SerializedPayload_t* payload) {
  const ByteView view = static_cast<const Sample*>(sample)->view;
  if (view.size() > payload->max_size) return false;
  std::memcpy(payload->data, view.data(), view.size());
  payload->encapsulation = CDR_LE;
  payload->length = static_cast<std::uint32_t>(view.size());
  return true;
}

bool BytesType::deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* sample) {
  const std::size_t least = kEncapsulation + (topic_.keyed ? kKey : 0);
  if (payload->length < least) {
    inbox_.count_refused_by_vendor();
    return false;
  }
  // One byte too many is kept of an oversized one: the inbox refuses and counts it.
  const std::size_t kept = std::min<std::size_t>(payload->length, topic_.max_bytes + kMostPadding + 1);
  Sample& read = *static_cast<Sample*>(sample);
  read.bytes.assign(payload->data, payload->data + kept);
  read.view = read.bytes;
  return true;
}

std::function<std::uint32_t()> BytesType::getSerializedSizeProvider(void* sample) {
  return [sample] { return static_cast<std::uint32_t>(static_cast<const Sample*>(sample)->view.size()); };
}

bool BytesType::getKey(void* sample, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool) {
  const ByteView view = static_cast<const Sample*>(sample)->view;
  if (!topic_.keyed || view.size() < kEncapsulation + kKey) return false;
  // A key of 16 bytes is its own hash (RTPS 2.5, 9.6.4.8).
  for (std::size_t i = 0; i < kKey; ++i) handle->value[i] = view[kEncapsulation + i];
  return true;
}

}  // namespace weft::bus::fastdds
