// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/pictures/picture_files.h"

#include "core/written_files.h"
#include "monitor/logs/pictures/png.h"
#include "monitor/mcap/byte_sink.h"

namespace galilean::logs {
namespace {

Result<void> write_picture(const std::string& path, bool replace, const std::string& content) {
  auto file = mcap::FileSink::create(path, replace);
  if (!file) return file.error();
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(content.data());
  auto done = file.value().write({bytes, content.size()});
  if (!done) remove_unfinished(path);
  return done;
}

}  // namespace

Result<void> write_pictures(const PictureFiles& files, const Drawing& drawing) {
  if (!files.svg.empty())
    if (auto done = write_picture(files.svg, files.replace, svg_of(drawing)); !done) return done;
  if (files.png.empty()) return {};
  const auto png = png_of(drawing);
  return png ? write_picture(files.png, files.replace, png.value()) : png.error();
}

}  // namespace galilean::logs
