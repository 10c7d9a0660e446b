// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/wire/endpoints.h"
#include "core/wire/reader.h"

namespace galilean::monitor {

/// Finds the texts of programs in messages that tell which one a robot runs, or should run. Each
/// file of a recording has them as attachments, so that they can be taken out of it as files.
class ProgramTexts {
 public:
  struct Text {
    std::string name;  ///< the program's hash, a slash, and the name of the file
    std::string text;
  };

  /// Returns the texts in a message that were not found before. It is empty for other messages.
  [[nodiscard]] std::vector<Text> find(const wire::EndpointInfo& writer,
                                       const wire::Received& received);
  /// Forgets what was found.
  void clear() { found_.clear(); }

 private:
  std::set<std::pair<std::string, std::size_t>> found_;  ///< name, and a hash of the text
};

}  // namespace galilean::monitor
