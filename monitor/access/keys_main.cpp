// SPDX-License-Identifier: BSD-3-Clause
// galilean-keys prints the public half of the operator's key, as robots' --trust files name it.
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "core/command_line/command_line.h"
#include "core/command_line/exit_code.h"
#include "core/signing/key_files.h"
#include "core/signing/trusted_keys.h"
#include "monitor/access/operator_key.h"
#include "monitor/access/tokens.h"

namespace {

using namespace galilean;

int print_key(const std::filesystem::path& data_folder) {
  const auto file = monitor::operator_key_file(data_folder);
  std::error_code unknown;
  const bool is_new = !std::filesystem::exists(file, unknown);
  const auto key = monitor::open_operator_key(data_folder);
  if (!key) {
    std::cerr << "galilean keys: " << key.error().message << '\n';
    return kFailed;
  }
  if (is_new)
    std::cerr << "galilean keys: made a new key, which is kept in " << file.string() << '\n';
  const auto line = TrustedKeys::load(public_key_file(file));
  std::cout << trust_line(key.value().verifying_key(), line ? line.value().all()[0].name : "");
  return std::cout.flush() ? EXIT_SUCCESS : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  std::filesystem::path data_folder = monitor::default_data_folder();
  CommandLine app(
      "Prints the line that names the operator's public key, for the file of a robot's --trust. "
      "Makes the key if there is none.",
      "galilean keys");
  app.option("--data", data_folder, "folder that keeps the key").names_folder();
  if (const auto code = app.parse(argc, argv)) return *code;
  return print_key(data_folder);
}
