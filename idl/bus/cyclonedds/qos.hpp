#pragma once
#include <dds/dds.h>

#include <memory>
#include <string>

#include "idl/bus/addresses.hpp"
#include "idl/bus/topics.hpp"

/// Translates the topic table's words into Cyclone DDS's.
namespace weft::bus::cyclonedds {

using Qos = std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)>;

std::string domain_xml(const BusConfig& config, const Addresses& addresses);
Qos writer_qos(const Topic& topic);
Qos reader_qos(const Topic& topic);
/// Returns the partition by which one peer is addressed, for publishers and subscribers.
Qos partition_qos(const PeerId& peer);

}  // namespace weft::bus::cyclonedds
