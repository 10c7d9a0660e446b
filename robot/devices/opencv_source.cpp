// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/opencv_source.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <system_error>

#include "core/installation.h"
#include "robot/devices/opencv_module.h"

namespace galilean::robot {
namespace {

/// Folders of the module relative to the executable: in the build, for the build's tests,
/// installed.
constexpr std::array kFolders{".", "../bin", "../lib/galilean"};

Result<std::filesystem::path> find_module() {
  const auto folder = program_folder();
  for (const auto* relative : kFolders) {
    const auto candidate = folder / relative / kOpencvModuleFile;
    std::error_code unknown;
    if (std::filesystem::exists(candidate, unknown)) return candidate;
  }
  return Error{std::string("The module for cameras and videos, ") + kOpencvModuleFile +
               ", is not beside the executable in " + folder.string() + ": build or install it."};
}

}  // namespace

Result<std::unique_ptr<FrameSource>> open_opencv_source(const std::string& device) {
  const auto path = find_module();
  if (!path) return path.error();
  // The module is never unloaded, because OpenCV's threads would go on in memory that is gone.
  auto* const module = dlopen(path.value().c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) return Error{std::string("OpenCV cannot be loaded: ") + dlerror() + '.'};
  const auto make = reinterpret_cast<MakeOpencvSource>(dlsym(module, kMakeOpencvSource));
  if (!make)
    return Error{path.value().string() + " is not a module of this release; build it again."};
  return std::unique_ptr<FrameSource>(make(device.c_str()));
}

}  // namespace galilean::robot
