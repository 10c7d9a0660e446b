// SPDX-License-Identifier: BSD-3-Clause
// Recovers broken recordings, as `galilean log recover` does. The input is a recording without its
// first bytes, or, behind a 1, changes to one that is whole: pairs of a place and a byte. What is
// written must be whole, and if nothing can be, that must be said. What is whole is recovered as it
// is, and what it says that it lacks is said by its copy, too.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

#include "core/command_line/exit_code.h"
#include "monitor/logs/writing/copies.h"
#include "monitor/record/copy_losses.h"
#include "tests/fuzz/input.h"
#include "tests/monitor/logs/writing/sample_recording.h"
#include "tests/monitor/record/faulty_disk.h"

namespace {

using namespace galilean;
using bhdl::must;

/// A folder of this process, which goes with it.
struct Folder {
  Folder()
      : path(std::filesystem::temp_directory_path() / ("recover_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path);
    // What recover tells would hide what the fuzzer does.
    std::cerr.rdbuf(nullptr);
    must(std::freopen("/dev/null", "w", stdout) != nullptr, "there is somewhere to print to");
  }
  ~Folder() {
    std::error_code gone_already;
    std::filesystem::remove_all(path, gone_already);
  }
  std::filesystem::path path;
};

/// Returns a small recording that is whole.
mcap::Bytes whole() {
  mcap::FaultyDisk disk;
  auto samples = logs::random_samples(1);
  samples.resize(100);
  must(logs::write_samples(samples, disk, mcap::Compression::kNone, [](std::size_t) {}).ok(),
       "a recording can be made");
  return disk.bytes();
}

/// Returns the recording that the input stands for.
mcap::Bytes recording_of(mcap::ByteView input) {
  static const mcap::Bytes untouched = whole();
  constexpr std::size_t kChangeBytes = 3;
  if (input.empty() || input[0] != 1) {
    mcap::Bytes bytes(std::begin(mcap::kMagic), std::end(mcap::kMagic));
    bytes.insert(bytes.end(), input.begin(), input.end());
    return bytes;
  }
  auto bytes = untouched;
  for (input = input.subspan(1); input.size() >= kChangeBytes; input = input.subspan(kChangeBytes))
    bytes[static_cast<std::size_t>(input[0] << 8 | input[1]) % bytes.size()] = input[2];
  // One byte that is left over says how much of the end is cut off.
  if (input.size() == 1) bytes.resize(bytes.size() * input[0] / 256);
  return bytes;
}

int recover(const std::string& from, const std::string& to) {
  return logs::copy_recordings(
      "recover", {.files = {from}, .output = {.path = to, .replace = true}, .read_again = true});
}

/// What a recovered file has, and what it says that it lacks.
struct Recovered {
  std::uint64_t messages;
  std::vector<monitor::CopyLosses> lacks;
  bool operator==(const Recovered&) const = default;
};

Recovered read_whole(const std::string& path) {
  const auto source = mcap::FileSource::open(path);
  must(source.ok(), "what was recovered is there");
  const auto summary = mcap::summarize(source.value(), mcap::Depth::kAll);
  must(summary && !summary.value().recovered(), "what was recovered is whole");
  return {summary.value().statistics.messages, monitor::copy_losses(summary.value())};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string broken = folder.path / "broken.mcap", mended = folder.path / "mended.mcap",
                    again = folder.path / "again.mcap";
  {
    const auto bytes = recording_of({data, size});
    std::ofstream(broken, std::ios::binary | std::ios::trunc)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  const int code = recover(broken, mended);
  must(code == 0 || code == kFailed || code == kIncomplete,
       "the exit code is one of those that are documented");
  if (code == kFailed) return 0;
  const auto first = read_whole(mended);
  must(code == kIncomplete || first.lacks.empty(),
       "a copy that lacks something is not called whole");
  const int again_code = recover(mended, again);
  must(again_code == (first.lacks.empty() ? 0 : kIncomplete), "what is whole has nothing to mend");
  must(read_whole(again) == first,
       "all that is whole is recovered, and what it lacks is still said");
  return 0;
}
