#pragma once
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "idl/bus/addresses.hpp"
#include "idl/bus/topics.hpp"

/// Translates the topic table's words into Fast DDS's.
namespace weft::bus::fastdds {

eprosima::fastdds::dds::DomainParticipantQos participant_qos(const BusConfig& config, const Addresses& addresses);
eprosima::fastdds::dds::DataWriterQos writer_qos(const Topic& topic);
eprosima::fastdds::dds::DataReaderQos reader_qos(const Topic& topic);

}  // namespace weft::bus::fastdds
