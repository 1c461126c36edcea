#pragma once
#include <dds/dds.h>

#include "core/bytes.hpp"

struct ddsi_serdata;

/// Passes bytes by Cyclone DDS's C structs, through its internal interface (0.10.2).
namespace weft::bus::cyclonedds {

/// Sends padded CDR; Cyclone DDS checks it against the topic's type first. Its return code.
dds_return_t write_bytes(dds_entity_t writer, ByteView padded);

/// Gives access to the bytes of a sample, as long as this lives.
class SerialisedSample {
 public:
  /// Takes over the reference.
  explicit SerialisedSample(ddsi_serdata* sample);
  ~SerialisedSample();
  SerialisedSample(const SerialisedSample&) = delete;
  SerialisedSample& operator=(const SerialisedSample&) = delete;
  ByteView bytes() const { return bytes_; }

 private:
  ddsi_serdata* sample_;
  ddsi_serdata* held_;
  ByteView bytes_;
};

}  // namespace weft::bus::cyclonedds
