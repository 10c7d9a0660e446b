// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/pictures/png.h"

#include <dlfcn.h>

#include <array>
#include <filesystem>
#include <system_error>

#include "core/installation.h"
#include "monitor/logs/pictures/png_module.h"

namespace galilean::logs {
namespace {

/// Folders of the module relative to the executable: in the build, for the build's tests,
/// installed.
constexpr std::array kModuleFolders{".", "../bin", "../lib/galilean"};

struct PngModule {
  DrawPng draw;
};

Result<PngModule> load_module() {
  const auto folder = program_folder();
  std::filesystem::path found;
  std::error_code unknown;
  for (const auto* relative : kModuleFolders)
    if (const auto path = folder / relative / kPngModuleFile;
        found.empty() && std::filesystem::exists(path, unknown))
      found = path;
  if (found.empty())
    return Error{std::string("the module for PNG pictures, ") + kPngModuleFile +
                 ", is not beside the executable in " + folder.string() +
                 ": build or install it, or write an SVG picture (--svg)"};
  // The module is never unloaded, because OpenCV's threads would go on in memory that is gone.
  auto* const module = dlopen(found.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) return Error{std::string("OpenCV cannot be loaded: ") + dlerror()};
  const auto draw = reinterpret_cast<DrawPng>(dlsym(module, kDrawPng));
  if (!draw) return Error{found.string() + " is not a module of this release; build it again"};
  return PngModule{draw};
}

}  // namespace

Result<std::string> png_of(const Drawing& drawing) {
  const auto module = load_module();
  if (!module) return module.error();
  std::string png;
  if (!module.value().draw(drawing, png)) return Error{"the picture cannot be drawn as PNG"};
  return png;
}

}  // namespace galilean::logs
