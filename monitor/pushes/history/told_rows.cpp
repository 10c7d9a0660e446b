// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/told_rows.h"

#include <string_view>

#include "monitor/pushes/history/chain.h"

namespace galilean::monitor::rows {
namespace {

std::vector<Told> told_pushes(sqlite3* database, const std::string& condition,
                              const std::string& id) {
  sql::Statement rows(database,
                      "SELECT id, pushed_ns, author, hash, targets, sequence FROM push LEFT JOIN "
                      "push_sequence ON push_sequence.push_id = id WHERE id " +
                          condition + " ORDER BY sequence, id");
  rows.bind(id);
  std::vector<Told> all;
  while (rows.step())
    all.push_back({.subject = rows.text(0),
                   .robot = {},
                   .content = {{"pushed_ns", rows.integer(1)},
                               {"author", rows.text(2)},
                               {"hash", rows.text(3)},
                               {"targets", rows.text(4)},
                               {"sequence", rows.integer(5)}}});
  return all;
}

std::vector<Told> told_replies(sqlite3* database, const std::string& condition,
                               const std::string& id) {
  sql::Statement rows(database,
                      "SELECT push_id, robot, status, message, running_hash, latency_ms FROM "
                      "answer WHERE push_id " +
                          condition + " ORDER BY push_id, robot");
  rows.bind(id);
  std::vector<Told> all;
  while (rows.step())
    all.push_back({.subject = rows.text(0),
                   .robot = rows.text(1),
                   .content = {{"robot", rows.text(1)},
                               {"status", rows.text(2)},
                               {"message", rows.text(3)},
                               {"running_hash", rows.text(4)},
                               {"latency_ms", rows.number(5)}}});
  return all;
}

std::vector<Told> told_progress(sqlite3* database, const std::string& condition,
                                const std::string& id) {
  sql::Statement rows(database,
                      "SELECT progress.push_id, state, steps, trial, told_ns FROM progress LEFT "
                      "JOIN told_later ON told_later.push_id = progress.push_id WHERE "
                      "progress.push_id " +
                          condition + " ORDER BY progress.push_id");
  rows.bind(id);
  std::vector<Told> all;
  while (rows.step())
    all.push_back({.subject = rows.text(0),
                   .robot = {},
                   .content = {{"state", rows.text(1)},
                               {"steps", rows.text(2)},
                               {"trial", rows.text(3)},
                               {"told_ns", rows.integer(4)}}});
  return all;
}

}  // namespace

std::vector<Told> told(sqlite3* database, const char* kind,
                       const std::optional<std::string>& push_id) {
  const std::string condition = push_id ? "= ?" : "IS NOT NULL AND ? = ''";
  const auto id = push_id.value_or("");
  const std::string_view word = kind;
  if (word == chain::kPush) return told_pushes(database, condition, id);
  if (word == chain::kReply) return told_replies(database, condition, id);
  return told_progress(database, condition, id);
}

}  // namespace galilean::monitor::rows
