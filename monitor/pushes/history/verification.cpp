// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/verification.h"

#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "bhdl/source/sha256.h"
#include "core/json_text.h"
#include "core/time_text.h"
#include "monitor/pushes/history/chain.h"
#include "monitor/pushes/history/history_rows.h"
#include "monitor/pushes/history/told_rows.h"

namespace galilean::monitor {
namespace {

/// What the chain tells last of something: the row, and its content.
struct Last {
  std::int64_t number = 0, time_ns = 0;
  nlohmann::json content;
};
/// The row of a push, and its program's hash.
struct PushedText {
  std::int64_t number = 0, time_ns = 0;
  std::string hash;
};
/// By kind, id and robot.
using Newest = std::map<std::tuple<std::string, std::string, std::string>, Last>;

bool is_of_table(const std::string& kind) {
  return kind == chain::kPush || kind == chain::kReply || kind == chain::kProgress;
}

/// Checks a row by itself and by the one before it. Returns what differs; nothing if it is whole.
std::optional<std::string> fault_of(const chain::Row& row, const chain::Row& before) {
  if (row.before != before.hash) return "it does not follow the row that stands before it now";
  if (row.hash != chain::hash_of(row)) return "its time or its content was changed";
  if (const auto json = read_json(row.content); !json || !json.value().is_object())
    return "its content cannot be read";
  return std::nullopt;
}

class Verifier {
 public:
  explicit Verifier(sqlite3* database) : database_(database) {}

  Verification run() {
    walk_chain();
    if (!found_.broken) check_end();
    compare_tables();
    check_texts();
    return std::move(found_);
  }

 private:
  /// The first broken row is the one with the lowest number; one without a number comes last.
  void report(BrokenRow row) {
    const auto rank = [](const BrokenRow& each) {
      return each.number == 0 ? std::numeric_limits<std::int64_t>::max() : each.number;
    };
    if (found_.broken && rank(row) > rank(*found_.broken)) return;
    if (found_.broken && row.number == found_.broken->number) {
      if (row.number != 0) found_.broken->what += "; " + row.what;
      return;
    }
    found_.broken = std::move(row);
  }

  void walk_chain() {
    auto rows = chain::select(database_, "ORDER BY number");
    chain::Row before{.number = 0,
                      .time_ns = 0,
                      .kind = {},
                      .subject = {},
                      .content = {},
                      .before = {},
                      .hash = chain::kNoHash};
    while (auto row = chain::next(rows)) {
      ++found_.rows;
      if (row->number != before.number + 1)
        report({before.number + 1, 0,
                "it is missing; the next row is of " + local_time(row->time_ns)});
      if (auto fault = fault_of(*row, before)) report({row->number, row->time_ns, *fault});
      note(*row);
      before = std::move(*row);
    }
    if (found_.rows > 0) found_.head = before.hash;
    last_ = before.number;
  }

  void note(const chain::Row& row) {
    auto json = read_json(row.content);
    if (!is_of_table(row.kind) || !json || !json.value().is_object()) return;
    const auto robot = row.kind == chain::kReply ? json.value().value("robot", "") : "";
    newest_[{row.kind, row.subject, robot}] = {row.number, row.time_ns, std::move(json).value()};
  }

  void check_end() {
    if (chain::last_number(database_) > last_)
      report({last_ + 1, 0, "it is missing, and so are all after it"});
  }

  void compare_tables() {
    for (const auto* kind : {chain::kPush, chain::kReply, chain::kProgress})
      for (const auto& row : rows::told(database_, kind)) compare(kind, row);
    for (const auto& [key, last] : newest_)
      report({last.number, last.time_ns,
              "the " + std::get<0>(key) + " of push " + std::get<1>(key) +
                  " was taken out of the list"});
  }

  void compare(const std::string& kind, const rows::Told& row) {
    const auto found = newest_.find({kind, row.subject, row.robot});
    if (found == newest_.end())
      return report(
          {0, 0, "the list has a " + kind + " of push " + row.subject + " of which no row tells"});
    const Last last = std::move(found->second);
    newest_.erase(found);
    for (const auto& [name, value] : row.content.items())
      if (const auto told = last.content.find(name);
          told == last.content.end() || json_text(*told) != json_text(value))
        return report({last.number, last.time_ns,
                       name + " of push " + row.subject + " differs: the row tells " +
                           (told == last.content.end() ? "none" : json_text(*told)) +
                           ", the list " + json_text(value)});
    if (kind == chain::kPush)
      pushes_.push_back({last.number, last.time_ns, row.content.value("hash", "")});
  }

  void check_texts() {
    for (const auto& push : pushes_) {
      if (push.hash.empty()) continue;
      const auto files = sql::attempt([&] { return rows::files_of(database_, push.hash); });
      if (!files || !files.value())
        report({push.number, push.time_ns,
                "the text of program " + push.hash +
                    (files ? " was taken away" : " was changed: it does not have this hash")});
    }
  }

  sqlite3* database_;
  Verification found_;
  Newest newest_;
  std::vector<PushedText> pushes_;
  std::int64_t last_ = 0;
};

/// Returns whether a row has a hash that begins with `noted`.
Result<bool> has_hash(sqlite3* database, const std::string& noted) {
  return sql::attempt([&] {
    auto rows = chain::select(database, "WHERE substr(hash, 1, length(?)) = ? LIMIT 1");
    rows.bind(noted).bind(noted);
    return noted.empty() || chain::next(rows).has_value();
  });
}

}  // namespace

Result<Verification> verify(sqlite3* database) {
  return sql::attempt([&] {
    const sql::Snapshot snapshot(database);
    return Verifier(database).run();
  });
}

Result<Verification> verify_history(const std::filesystem::path& file, const std::string& noted) {
  sqlite3* opened = nullptr;
  const int result = sqlite3_open_v2(file.c_str(), &opened, SQLITE_OPEN_READONLY, nullptr);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, sqlite3_close);
  const std::string name = " (" + file.string() + ")";
  if (result != SQLITE_OK)
    return Error{std::string("the history cannot be read: ") + sqlite3_errmsg(opened) + name};
  sqlite3_busy_timeout(opened, 2000);
  if (sqlite3_table_column_metadata(opened, nullptr, "chain", nullptr, nullptr, nullptr, nullptr,
                                    nullptr, nullptr) != SQLITE_OK)
    return Error{std::string("the history cannot be read, or it is older than this release: ") +
                 sqlite3_errmsg(opened) + "; its monitor's next start adds the chain" + name};
  auto found = verify(opened);
  if (!found) return Error{found.error().message + name};
  const auto is_there = has_hash(opened, noted);
  if (!is_there) return Error{is_there.error().message + name};
  if (!is_there.value() && !found.value().broken)
    found.value().broken = BrokenRow{
        0, 0, "the row with the hash " + noted + " was taken away, or the chain was made anew"};
  return found;
}

std::string in_words(const Verification& verification) {
  if (!verification.broken)
    return "The history is whole: " + std::to_string(verification.rows) + " rows" +
           (verification.head.empty() ? "" : ", the last one with the hash " + verification.head) +
           ".";
  const auto& row = *verification.broken;
  const std::string which = row.number == 0
                                ? "One row that the chain does not have"
                                : "Row " + std::to_string(row.number) +
                                      (row.time_ns == 0 ? "" : " of " + local_time(row.time_ns));
  return "The history is broken. " + which + ": " + row.what + ".";
}

}  // namespace galilean::monitor
