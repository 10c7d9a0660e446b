// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/demo/recorder_words.h"

#include <fstream>
#include <string_view>

namespace galilean::front {
namespace {

constexpr std::string_view kRecorderSays = "galilean-record: ";

}  // namespace

/// A line that has no end yet is left for the next time.
std::vector<std::string> RecorderWords::take() {
  std::ifstream in(log_, std::ios::binary);
  in.seekg(read_);
  std::vector<std::string> sentences;
  for (std::string line; std::getline(in, line) && !in.eof();) {
    read_ += static_cast<std::streamoff>(line.size()) + 1;
    if (line.starts_with(kRecorderSays)) sentences.push_back(line.substr(kRecorderSays.size()));
  }
  return sentences;
}

bool tells_of_full_disk(const std::string& sentence) {
  return sentence.find("(--min-free): nothing is recorded") != std::string::npos;
}

}  // namespace galilean::front
