#pragma once
#include <fastdds/dds/topic/TopicDataType.hpp>

#include "core/bytes.hpp"
#include "idl/bus/inbox.hpp"
#include "idl/bus/topics.hpp"

namespace weft::bus::fastdds {

/// Passes a message to and from Fast DDS: to be written, a view of padded bytes; as read, bytes of its own.
struct Sample {
  ByteView view;
  Bytes bytes;
};

/// Lets Fast DDS carry any of our types as bytes. The key of keyed ones is read at its fixed place.
class BytesType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  BytesType(const Topic& topic, Inbox& inbox);

  bool serialize(void* sample, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* sample) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* sample) override;
  void* createData() override { return new Sample; }
  void deleteData(void* sample) override { delete static_cast<Sample*>(sample); }
  bool getKey(void* sample, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override;

 private:
  const Topic& topic_;
  Inbox& inbox_;
};

}  // namespace weft::bus::fastdds
