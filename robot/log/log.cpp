// SPDX-License-Identifier: BSD-3-Clause
#include "robot/log/log.h"

#include <spdlog/spdlog.h>

namespace galilean::robot {

void log_info(std::string_view line) {
  spdlog::default_logger_raw()->log(spdlog::level::info, line);
}

void log_warning(std::string_view line) {
  spdlog::default_logger_raw()->log(spdlog::level::warn, line);
}

void log_error(std::string_view line) {
  spdlog::default_logger_raw()->log(spdlog::level::err, line);
}

}  // namespace galilean::robot
