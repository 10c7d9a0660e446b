// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/http/page_files.h"

#include <fstream>

#include "bhdl/source/sha256.h"
#include "core/installation.h"
#include "monitor/compression/gzip.h"
#include "monitor/server/http/http_caching.h"
#include "monitor/server/http/page_policy.h"

namespace galilean::monitor {
namespace {
namespace fs = std::filesystem;

constexpr const char* kCompressed =
    ".gz";                    ///< ends the name of a file that the page's build compressed
constexpr int kSmallest = 9;  ///< gzip's level for files that the build did not compress
constexpr const char* kNotBuilt =
    "<!doctype html><title>Galilean</title><h1>The page is not built</h1>"
    "<p>The monitor runs. Build the page with <code>npm ci &amp;&amp; npm run build</code> in "
    "<code>web/</code>, and name its folder with <code>--web web/dist</code>; "
    "<code>./demo.sh</code> does both.</p>";

std::string type_of(const fs::path& file) {
  static const std::map<std::string, std::string> kTypes{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".txt", "text/plain; charset=utf-8"},
      {".webmanifest", "application/manifest+json"},
  };
  const auto found = kTypes.find(file.extension().string());
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

/// Returns an empty string if the file cannot be read.
std::string content_of(const fs::path& file) {
  std::error_code failed;
  const auto size = fs::file_size(file, failed);
  std::string content(failed ? 0 : size, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(content.data(), static_cast<std::streamsize>(content.size()));
  content.resize(static_cast<std::size_t>(in.gcount()));
  return content;
}

}  // namespace

PageFiles::PageFiles(const fs::path& folder) {
  std::error_code failed;
  for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    if (!at->is_regular_file(failed) || at->path().extension() == kCompressed) continue;
    add("/" + at->path().lexically_relative(folder).generic_string(), content_of(at->path()),
        content_of(at->path().string() + kCompressed));
  }
  if (!has("/index.html")) add("/index.html", kNotBuilt, {});
  policy_ = page_policy(*files_.at("/index.html").plain);
}

void PageFiles::add(const std::string& path, std::string content, std::string small) {
  File& file = files_[path];
  file.content_type = type_of(path);
  file.etag = "W/\"" + bhdl::sha256(content).substr(0, 32) + '"';
  if (small.empty()) small = gzipped(content, kSmallest);
  if (small.size() < content.size() * 9 / 10)
    file.gzip = std::make_shared<const std::string>(std::move(small));
  file.plain = std::make_shared<const std::string>(std::move(content));
}

HttpResponse PageFiles::get(const HttpRequest& request) const {
  const auto found = files_.find(request.path == "/" ? "/index.html" : request.path);
  if (found == files_.end()) return problem(404, "There is no '" + request.path + "' here.");
  const File& file = found->second;
  const bool for_ever = found->first.starts_with("/assets/");
  HttpResponse response{200, file.content_type, file.plain, {}};
  response.headers = {
      {"ETag", file.etag},
      {"Vary", "Accept-Encoding"},
      {"Cache-Control", for_ever ? "public, max-age=31536000, immutable" : "no-cache"},
      {"Content-Security-Policy", policy_ + connect_policy(request.host)}};
  if (is_known(request.if_none_match, file.etag)) {
    response.status = 304;
    response.body.reset();
  } else if (file.gzip && request.accepts_gzip) {
    response.body = file.gzip;
    response.headers.emplace_back("Content-Encoding", "gzip");
  }
  return response;
}

fs::path default_page_folder() {
  return shipped("web");
}

}  // namespace galilean::monitor
