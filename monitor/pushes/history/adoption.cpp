// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/adoption.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bhdl/source/sha256.h"
#include "monitor/pushes/history/chain.h"
#include "monitor/pushes/history/history_rows.h"
#include "monitor/pushes/history/told_rows.h"

namespace galilean::monitor {
namespace {

using Files = std::vector<bhdl::SourceFile>;

std::map<std::string, Files> kept_texts(sqlite3* database) {
  sql::Statement rows(database,
                      "SELECT hash, path, text FROM program_file ORDER BY hash, position");
  std::map<std::string, Files> texts;
  while (rows.step()) texts[rows.text(0)].push_back({rows.text(1), rows.text(2)});
  return texts;
}

/// Returns how many of the files, from the first on, have the hash; 0: no number of them has.
/// A text that was kept under the hash of a shorter one left its further files beside it.
std::size_t count_with_hash(const std::string& hash, Files files) {
  for (; !files.empty(); files.pop_back())
    if (bhdl::program_hash(files) == hash) return files.size();
  return 0;
}

void keep_only(sqlite3* database, const std::string& hash, std::size_t count) {
  sql::Statement(database, "DELETE FROM program_file WHERE hash = ? AND position >= ?")
      .bind(hash)
      .bind(static_cast<std::int64_t>(count))
      .run();
}

/// Puts texts where they belong. Returns [{from, to}] of those that stood under another hash.
nlohmann::json move_texts(sqlite3* database) {
  auto moved = nlohmann::json::array();
  for (const auto& [hash, files] : kept_texts(database)) {
    const auto count = count_with_hash(hash, files);
    if (count == files.size()) continue;
    keep_only(database, hash, count);
    msg::ProgramPush text;
    for (const auto& file : files) text.files.push_back({file.path, file.text});
    rows::put_files(database, text);
    moved.push_back({{"from", hash}, {"to", bhdl::program_hash(files)}});
  }
  return moved;
}

}  // namespace

void adopt_old_rows(sqlite3* database, std::int64_t now_ns) {
  if (chain::last_number(database) > 0) return;
  const auto pushes = rows::told(database, chain::kPush);
  if (pushes.empty()) return;
  chain::append(database, now_ns, chain::kAdopted, {},
                {{"pushes", pushes.size()}, {"texts_moved", move_texts(database)}});
  for (const auto* kind : {chain::kPush, chain::kReply, chain::kProgress})
    for (const auto& row : rows::told(database, kind))
      chain::append(database, now_ns, kind, row.subject, row.content);
}

}  // namespace galilean::monitor
