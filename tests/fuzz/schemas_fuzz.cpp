// SPDX-License-Identifier: BSD-3-Clause
// Reads random schemas in both encodings, and makes the types that they define.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "monitor/schemas/ros2idl.h"
#include "monitor/schemas/ros2msg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace galilean::monitor;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const auto& definitions : {parse_ros2idl(text), parse_ros2msg("a_msgs/msg/A", text)})
    if (definitions)
      for (const auto& [name, definition] : definitions.value())
        (void)make_type(definitions.value(), name);
  return 0;
}
