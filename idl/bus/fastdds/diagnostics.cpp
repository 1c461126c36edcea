#include "idl/bus/fastdds/diagnostics.hpp"

#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/log/StdoutErrConsumer.hpp>
#include <memory>

namespace weft::bus::fastdds {

void write_diagnostics_to_stderr() {
  using eprosima::fastdds::dds::Log;
  // Fast DDS has one log a process: a second call would end the consumer that another bus is served by.
  [[maybe_unused]] static const bool done = [] {
    auto consumer = std::make_unique<eprosima::fastdds::dds::StdoutErrConsumer>();
    consumer->stderr_threshold(Log::Kind::Info);  // the least severe kind: nothing is left for stdout
    Log::ClearConsumers();
    Log::RegisterConsumer(std::move(consumer));
    return true;
  }();
}

}  // namespace weft::bus::fastdds
