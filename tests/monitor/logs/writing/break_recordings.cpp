// SPDX-License-Identifier: BSD-3-Clause
// break_recordings kill|cut|flip COUNT FOLDER: makes so many broken recordings and recovers each
// into FOLDER. kill ends the writing process within its writes, one after another; cut ends files,
// and flip changes a byte, at places all over them. Prints a JSON line for each: its file, the exit
// code of recover, and how many messages were recovered. Ends with 1 and a sentence where less was
// recovered than must be, or something else.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>

#include "tests/monitor/logs/writing/dying_sink.h"
#include "tests/monitor/logs/writing/recovered_file.h"
#include "tests/monitor/record/faulty_disk.h"

namespace {

using namespace galilean;
using namespace galilean::logs;

constexpr mcap::Compression kCompressions[] = {mcap::Compression::kFast, mcap::Compression::kNone,
                                               mcap::Compression::kLz4};

/// What this program prints; recover prints to standard output, too, which goes nowhere.
std::FILE* answers = nullptr;
std::string folder;

std::string broken_path() {
  return folder + "/broken.mcap";
}

/// Recovers what stands at broken_path() and tells of it.
RecoveredFile recover_and_tell(const std::string& name) {
  auto recovered = recover(broken_path(), folder + "/" + name);
  std::fprintf(answers, "{\"file\":\"%s\",\"code\":%d,\"messages\":%zu}\n", name.c_str(),
               recovered.code, recovered.samples.size());
  std::fflush(answers);  // a process that is forked must not have it, too
  return recovered;
}

/// Returns how many samples the writer of a process had accepted that ended in a write.
std::size_t accepted_until_killed(const std::vector<Sample>& samples, mcap::Compression compression,
                                  std::size_t write, std::atomic<std::size_t>& accepted) {
  accepted = 0;
  const pid_t child = fork();
  if (child == 0) {
    auto file = mcap::FileSink::create(broken_path(), true);
    if (!file) _exit(1);
    DyingSink sink(std::move(file).value(), write, write * 7919 % 1000);
    (void)write_samples(samples, sink, compression, [&](std::size_t count) { accepted = count; });
    _exit(0);
  }
  int status = 0;
  promise(waitpid(child, &status, 0) == child && WIFEXITED(status) &&
              WEXITSTATUS(status) == DyingSink::kDied,
          "the writer did not die at write " + std::to_string(write));
  return accepted;
}

void kill_at_each_write(std::size_t count) {
  void* shared = mmap(nullptr, sizeof(std::atomic<std::size_t>), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  promise(shared != MAP_FAILED, "no shared memory");
  auto& accepted = *new (shared) std::atomic<std::size_t>(0);
  std::size_t kills = 0;
  for (unsigned seed = 0; kills < count; ++seed) {
    const auto samples = random_samples(seed);
    const auto compression = kCompressions[seed % std::size(kCompressions)];
    CountingSink counting;
    promise(write_samples(samples, counting, compression, [](std::size_t) {}).ok(), "no writes");
    for (std::size_t write = 0; write < counting.writes() && kills < count; ++write, ++kills) {
      const auto given = accepted_until_killed(samples, compression, write, accepted);
      const std::string name = "kill_" + std::to_string(kills) + ".mcap";
      const auto recovered = recover_and_tell(name);
      promise_all_but_a_second(recovered.samples, samples, given, name);
      promise(recovered.code != 0, name + ": recover says that it was whole");
    }
  }
}

void write_broken(mcap::ByteView bytes) {
  std::ofstream(broken_path(), std::ios::binary | std::ios::trunc)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

/// A recording that is whole.
struct WholeFile {
  std::vector<Sample> samples;
  std::vector<std::size_t> sizes;  ///< of the file, when its writer had accepted each sample
  mcap::Bytes bytes;
};

WholeFile whole_file(unsigned seed) {
  WholeFile file{.samples = random_samples(seed), .sizes = {}, .bytes = {}};
  mcap::FaultyDisk disk;
  const auto compression = kCompressions[seed % std::size(kCompressions)];
  const auto done = write_samples(file.samples, disk, compression,
                                  [&](std::size_t) { file.sizes.push_back(disk.bytes().size()); });
  promise(done.ok(), "the recording cannot be made");
  file.bytes = disk.bytes();
  return file;
}

/// Calls `break_at` with places in one recording of each compression.
template <class BreakAt>
void at_places(std::size_t count, const BreakAt& break_at) {
  const std::size_t each = (count + std::size(kCompressions) - 1) / std::size(kCompressions);
  for (unsigned seed = 0; seed < std::size(kCompressions); ++seed) {
    const auto whole = whole_file(seed);
    for (std::size_t i = 0; i < each; ++i)
      break_at(whole, i * whole.bytes.size() / each,
               std::to_string(seed) + "_" + std::to_string(i) + ".mcap");
  }
}

void cut_at_places(std::size_t count) {
  at_places(count, [](const WholeFile& whole, std::size_t at, const std::string& suffix) {
    const std::string name = "cut_" + suffix;
    write_broken(mcap::ByteView(whole.bytes).first(at));
    const auto recovered = recover_and_tell(name);
    promise(recovered.code != 0, name + ": recover says that it was whole");
    const auto accepted = std::ranges::upper_bound(whole.sizes, at) - whole.sizes.begin();
    promise_all_but_a_second(recovered.samples, whole.samples, static_cast<std::size_t>(accepted),
                             name);
  });
}

void flip_at_places(std::size_t count) {
  at_places(count, [](const WholeFile& whole, std::size_t at, const std::string& suffix) {
    const std::string name = "flip_" + suffix;
    auto bytes = whole.bytes;
    bytes[at] ^= static_cast<std::uint8_t>(1U << at % 8);
    write_broken(bytes);
    const auto recovered = recover_and_tell(name);
    promise(recovered.code != 1, name + ": nothing was recovered");
    promise_one_second(recovered.samples, whole.samples, name);
    promise(recovered.code != 0 || recovered.samples == whole.samples,
            name + ": recover says that it was whole, and messages are lost");
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const std::string how = argv[1];
  const auto count = static_cast<std::size_t>(std::stoul(argv[2]));
  folder = argv[3];
  answers = fdopen(dup(STDOUT_FILENO), "w");
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  if (how == "kill") kill_at_each_write(count);
  if (how == "cut") cut_at_places(count);
  if (how == "flip") flip_at_places(count);
  return 0;
}
