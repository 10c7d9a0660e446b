// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "monitor/server/http/http_messages.h"

namespace galilean::monitor {

/// The page's files. All files below a folder are read once and served from memory. Clients that
/// take gzip get X.gz, where it stands beside X, or the monitor compresses X. The names below
/// assets/ carry a hash of the content, so clients may keep these files for ever. Clients ask for
/// the other files again with their ETag.
class PageFiles {
 public:
  /// If the folder has no index.html, a page that says how to build it takes its place.
  explicit PageFiles(const std::filesystem::path& folder);

  /// Returns the file as 200 or 304, or 404 if there is no such file.
  [[nodiscard]] HttpResponse get(const HttpRequest& request) const;
  [[nodiscard]] bool has(const std::string& path) const { return files_.contains(path); }

 private:
  struct File {
    std::shared_ptr<const std::string> plain;
    std::shared_ptr<const std::string> gzip;  ///< null if that saves less than a tenth
    std::string content_type;
    std::string etag;
  };

  void add(const std::string& path, std::string content, std::string small);

  std::map<std::string, File> files_;  ///< by path, such as "/assets/index-1a2b.js"
  std::string policy_;  ///< the page's Content-Security-Policy, but for what it may connect to
};

/// Returns the folder of the installed page.
[[nodiscard]] std::filesystem::path default_page_folder();

}  // namespace galilean::monitor
