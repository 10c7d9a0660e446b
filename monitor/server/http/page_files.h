// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// The page: every file below a folder, read once and served from memory, with the X.gz beside a
/// file X as what is sent to those who take gzip. Names below assets/ carry a hash of their content
/// and may be kept for ever; the others are asked for again by their ETag.
class PageFiles {
 public:
  /// A folder that is not there gives a page that says how to build it.
  explicit PageFiles(const std::filesystem::path& folder);

  /// 404 if there is no such file.
  [[nodiscard]] HttpResponse get(const HttpRequest& request) const;
  [[nodiscard]] bool has(const std::string& path) const { return files_.contains(path); }

 private:
  struct File {
    std::shared_ptr<const std::string> plain;
    std::shared_ptr<const std::string> gzip;  ///< none where it would not be smaller
    std::string content_type;
    std::string etag;
  };

  void add(const std::string& path, std::string content, std::string small);

  std::map<std::string, File> files_;  ///< by "/assets/index-1a2b.js"
};

/// The page as it ships.
[[nodiscard]] std::filesystem::path default_page_folder();

}  // namespace galilean::monitor
