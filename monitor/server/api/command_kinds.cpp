// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/api/command_kinds.h"

#include "core/wire/messages.h"

namespace galilean::monitor {

const std::map<std::string, std::uint8_t>& command_kinds() {
  namespace kinds = msg::Command_Constants;
  static const std::map<std::string, std::uint8_t> kKinds{{"hold", kinds::HOLD},
                                                          {"resume", kinds::RESUME},
                                                          {"step", kinds::STEP},
                                                          {"push_bumper", kinds::PUSH_BUMPER},
                                                          {"decommission", kinds::DECOMMISSION},
                                                          {"commission", kinds::COMMISSION}};
  return kKinds;
}

}  // namespace galilean::monitor
