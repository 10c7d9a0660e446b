// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/map/export/map_files.h"

#include <zlib.h>

#include <sstream>
#include <vector>

namespace galilean::monitor {
namespace {

constexpr std::uint8_t kFree = 254, kOccupied = 0, kUnknown = 205;
constexpr int kOccupiedFrom_percent = 65, kFreeTo_percent = 25;
/// map_server reads a grey g as the probability (255 - g) / 255 of being occupied. That of kUnknown
/// is a little above this threshold.
constexpr double kFreeBelow = 0.196;

std::uint8_t grey(std::int8_t occupied_percent) {
  if (occupied_percent >= kOccupiedFrom_percent) return kOccupied;
  return occupied_percent >= 0 && occupied_percent <= kFreeTo_percent ? kFree : kUnknown;
}

void put_big_endian(std::string& to, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) to += static_cast<char>(number >> shift & 255);
}

void put_chunk(std::string& png, const std::string& type, const std::string& data) {
  put_big_endian(png, static_cast<std::uint32_t>(data.size()));
  const std::string content = type + data;
  png += content;
  put_big_endian(png,
                 static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                                  static_cast<uInt>(content.size()))));
}

std::string deflated(const std::vector<std::uint8_t>& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  compress(reinterpret_cast<Bytef*>(result.data()), &size, bytes.data(),
           static_cast<uLong>(bytes.size()));
  result.resize(size);
  return result;
}

}  // namespace

/// Makes a PNG (ISO 15948) with one grey channel of 8 bits. Every row begins with its filter, 0.
std::string map_png(const msg::OccupancyGrid& grid) {
  std::vector<std::uint8_t> rows;
  rows.reserve((grid.info.width + 1) * std::size_t{grid.info.height});
  for (std::uint32_t row = grid.info.height; row-- > 0;) {
    rows.push_back(0);
    for (std::uint32_t column = 0; column < grid.info.width; ++column)
      rows.push_back(grey(grid.data[row * std::size_t{grid.info.width} + column]));
  }
  std::string header;
  put_big_endian(header, grid.info.width);
  put_big_endian(header, grid.info.height);
  header += std::string{8, 0, 0, 0, 0};
  std::string png = "\x89PNG\r\n\x1a\n";
  put_chunk(png, "IHDR", header);
  put_chunk(png, "IDAT", deflated(rows));
  put_chunk(png, "IEND", {});
  return png;
}

std::string map_yaml(const msg::OccupancyGrid& grid) {
  std::ostringstream yaml;
  yaml << "image: map.png\nmode: trinary\nresolution: " << grid.info.resolution << "\norigin: ["
       << grid.info.origin.position.x << ", " << grid.info.origin.position.y
       << ", 0]\nnegate: 0\noccupied_thresh: " << kOccupiedFrom_percent / 100.0
       << "\nfree_thresh: " << kFreeBelow << '\n';
  return yaml.str();
}

}  // namespace galilean::monitor
