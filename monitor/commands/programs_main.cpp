// SPDX-License-Identifier: BSD-3-Clause
#include <iomanip>
#include <iostream>

#include "bhdl/check.h"
#include "bhdl/diff/diff.h"
#include "bhdl/program/catalog_file.h"
#include "core/command_line/command_line.h"
#include "core/json_text.h"
#include "core/time_text.h"
#include "core/visible_text.h"
#include "monitor/access/tokens.h"
#include "monitor/commands/push_session.h"
#include "monitor/pushes/history/json.h"
#include "monitor/pushes/history/verification.h"
#include "monitor/pushes/history/words.h"

namespace {
using namespace galilean::monitor;
namespace bhdl = galilean::bhdl;
using galilean::json_text;
using galilean::local_time;
using galilean::visible;
using nlohmann::json;
using Files = std::vector<bhdl::SourceFile>;

constexpr const char* kCommand = "galilean programs";
// As diff does: what differs is no failure of the command.
constexpr int kDiffer = 1, kNotCompared = 2;
constexpr int kBroken = 1, kUnreadable = 3;

int fail(const std::string& why, int exit_code = galilean::kFailed) {
  std::cerr << kCommand << ": " << why << std::endl;
  return exit_code;
}

std::string joined(const json& names) {
  std::string text;
  for (const auto& name : names)
    text += (text.empty() ? "" : ",") + visible(name.get<std::string>());
  return text.empty() ? "team" : text;
}

/// Returns what each robot replied; where no robot was asked, what the push failed at.
std::string outcomes(const json& push) {
  std::string text;
  for (const auto& reply : push.value("replies", json::array()))
    text += (text.empty() ? "" : ", ") +
            visible(reply.value("robot", "") + " " + reply.value("status", ""));
  for (const auto& step : push.value("steps", json::array()))
    if (const auto state = step_state_of(step.value("state", ""));
        text.empty() && (state == StepState::kFailed || state == StepState::kCancelled))
      text = visible(step.value("detail", ""));
  return text.empty() ? "no answer is known" : text;
}

/// Says that there is no push yet. `url` names the monitor.
void tell_empty(const std::string& url) {
  std::cerr << kCommand << ": no program was pushed yet through the monitor at " << url
            << ". It looks in history.sqlite in the folder of its --data. Without --data that is "
            << default_data_folder().string()
            << ", and for another DDS domain than 0 or another port than 8080 the folder "
            << "histories/domain-N-port-P in it.\n";
}

/// Returns the push's state, and when it was told if that was later.
std::string state_words(const json& push) {
  const auto word = push.value("state", "");
  if (push_state_of(word) != PushState::kToldLater) return word;
  return "confirmed (told later, " + local_time(push.value("told_ns", std::int64_t{})) + ") ";
}

int list(const MonitorClient& monitor, const std::string& url, bool as_json) {
  const auto answer = monitor.get("/api/pushes");
  if (!answer) return fail(answer.error().message);
  if (!answer.value().ok()) return fail(answer.value().detail());
  if (as_json) return std::cout << json_text(answer.value().json, 1) << std::endl, EXIT_SUCCESS;
  const auto& pushes = answer.value().json["pushes"];
  if (pushes.empty()) tell_empty(url);
  for (const auto& push : pushes)
    std::cout << local_time(push.value("pushed_ns", std::int64_t{})) << "  "
              << visible(push.value("hash", "").substr(0, 12)) << "  " << std::left << std::setw(24)
              << visible(push.value("program", "")) << ' ' << std::setw(10)
              << visible(push.value("author", "")) << ' ' << std::setw(12)
              << visible(state_words(push)) << "to " << joined(push["targets"]) << ": "
              << outcomes(push) << '\n';
  return EXIT_SUCCESS;
}

/// Returns what became of an order, such as "io is held, ganymede was silent for 2 s".
std::string order_outcomes(const json& order) {
  std::string text;
  for (const auto& each : order.value("outcomes", json::array()))
    text += (text.empty() ? "" : ", ") +
            visible(each.value("of", "") + " " + each.value("outcome", ""));
  return text.empty() ? "no outcome is known" : text;
}

int list_orders(const MonitorClient& monitor, bool as_json) {
  const auto answer = monitor.get("/api/orders");
  if (!answer) return fail(answer.error().message);
  if (!answer.value().ok()) return fail(answer.value().detail());
  if (as_json) return std::cout << json_text(answer.value().json, 1) << std::endl, EXIT_SUCCESS;
  for (const auto& order : answer.value().json.value("orders", json::array()))
    std::cout << local_time(order.value("ordered_ns", std::int64_t{})) << "  " << std::left
              << std::setw(20) << visible(order.value("kind", "")) << ' ' << std::setw(12)
              << visible(order.value("author", "")) << "to "
              << joined(order.value("targets", json::array()))
              << (order.value("detail", "").empty() ? "" : " (")
              << visible(order.value("detail", ""))
              << (order.value("detail", "").empty() ? "" : ")") << ": " << order_outcomes(order)
              << '\n';
  return EXIT_SUCCESS;
}

int verify(const std::filesystem::path& data_folder, const std::string& noted) {
  const auto found = verify_history(data_folder / "history.sqlite", noted);
  if (!found) return fail(found.error().message, kUnreadable);
  std::cout << visible(in_words(found.value())) << std::endl;
  return found.value().broken ? kBroken : EXIT_SUCCESS;
}

galilean::Result<Files> pushed(const MonitorClient& monitor, const std::string& hash) {
  auto answer = monitor.get("/api/pushed/" + hash);
  if (!answer) return answer.error();
  if (!answer.value().ok()) return galilean::Error{answer.value().detail()};
  return files_from_json(answer.value().json["files"]);
}

int show(const MonitorClient& monitor, const std::string& hash) {
  const auto files = pushed(monitor, hash);
  if (!files) return fail(files.error().message);
  const bool several = files.value().size() > 1;
  for (const auto& file : files.value()) {
    if (several) std::cout << "; " << file.path << '\n';
    std::cout << file.text;
    if (!file.text.ends_with('\n')) std::cout << '\n';
  }
  return EXIT_SUCCESS;
}

/// `name` is a file on this machine, or the hash of a program that was pushed.
galilean::Result<bhdl::Program> program_named(const MonitorClient& monitor, const std::string& name,
                                              const galilean::Catalog& catalog) {
  bhdl::CheckResult checked;
  if (std::error_code none; std::filesystem::is_regular_file(name, none)) {
    checked = bhdl::check_file(name, catalog);
  } else {
    auto files = pushed(monitor, name);
    if (!files) return files.error();
    checked = bhdl::check(std::move(files).value(), catalog);
  }
  if (checked.program) return std::move(*checked.program);
  std::string why = name + " does not check here:";
  for (const auto& diagnostic : checked.diagnostics) why += "\n  " + bhdl::format(diagnostic);
  return galilean::Error{why};
}

struct Comparison {
  std::string from, to;
  std::filesystem::path catalog_file = bhdl::default_catalog_path();
  bool as_json = false;
};

int diff(const MonitorClient& monitor, const Comparison& what) {
  const auto catalog = bhdl::load_catalog(what.catalog_file);
  if (!catalog) return fail(catalog.error().message, kNotCompared);
  const auto before = program_named(monitor, what.from, catalog.value());
  if (!before) return fail(before.error().message, kNotCompared);
  const auto after = program_named(monitor, what.to, catalog.value());
  if (!after) return fail(after.error().message, kNotCompared);
  const auto changes = bhdl::differences(before.value(), after.value(), catalog.value());
  if (what.as_json)
    std::cout << json_text(json{{"same", changes.empty()},
                                {"from", before.value().hash},
                                {"to", after.value().hash},
                                {"changes", changes}},
                           1)
              << std::endl;
  else
    for (const auto& change : changes) std::cout << bhdl::in_words(change) << '\n';
  return changes.empty() ? EXIT_SUCCESS : kDiffer;
}

int restore(const MonitorClient& monitor, const std::string& hash, const PushOptions& options) {
  const auto files = pushed(monitor, hash);
  if (!files) return fail(files.error().message);
  return push_through(monitor, kCommand, files.value(), options);
}

}  // namespace

int main(int argc, char** argv) {
  PushOptions options;
  Comparison comparison;
  std::string hash;
  bool list_as_json = false;
  std::filesystem::path data_folder = default_data_folder();
  std::string noted;
  galilean::CommandLine app(
      "Lists, shows, compares and restores pushed programs, and verifies their history.", kCommand);
  app.require_command();
  app.share_options();
  add_monitor_option(app, options);
  auto listing = app.command("list", "list the last pushes, with their times, authors and results");
  listing.flag("--json", list_as_json, "as JSON");
  auto orders = app.command(
      "orders", "list the last orders that are no pushes: hold, stop, breaks, the instructor's");
  orders.flag("--json", list_as_json, "as JSON");
  auto verifying =
      app.command("verify", "check that no row of the history was changed or taken away");
  verifying.option("--data", data_folder, "the folder that has the monitor's history.sqlite")
      .names_folder();
  verifying
      .option("--head", noted,
              "a hash that an earlier verification printed, or the beginning of it: the row that "
              "has it must still be there")
      .not_empty();
  verifying.describe_exit(kBroken, "A row was changed or taken away; the first one is printed.");
  verifying.describe_exit(kUnreadable, "The history cannot be read.");
  auto showing = app.command("show", "print a program's text");
  showing.option("hash", hash, "the program's hash, or the beginning of it").required();
  auto comparing = app.command("diff", "print what program B does differently from program A");
  comparing.option("A", comparison.from, "a hash, or a file").required().names_file(".bhdl");
  comparing.option("B", comparison.to, "a hash, or a file").required().names_file(".bhdl");
  comparing
      .option("--catalog", comparison.catalog_file,
              "JSON file of the components; without it this build's")
      .names_file(".json");
  comparing.flag("--json", comparison.as_json, "as JSON");
  comparing.describe_exit(kDiffer, "The programs differ.");
  comparing.describe_exit(kNotCompared, "The programs cannot be compared.");
  auto restoring = app.command("restore", "push a program again");
  restoring.option("hash", hash, "the program's hash, or the beginning of it").required();
  add_push_options(restoring, options);
  if (const auto code = app.parse(argc, argv)) return *code;
  if (const auto targets = check_targets(options); restoring.chosen() && !targets)
    return app.refuse(targets.error().message);
  if (verifying.chosen()) return verify(data_folder, noted);
  const auto monitor = MonitorClient::at(options.monitor, options.token_file, options.trust);
  if (!monitor)
    return fail(monitor.error().message, comparing.chosen() ? kNotCompared : galilean::kFailed);
  if (listing.chosen()) return list(monitor.value(), options.monitor, list_as_json);
  if (orders.chosen()) return list_orders(monitor.value(), list_as_json);
  if (showing.chosen()) return show(monitor.value(), hash);
  if (comparing.chosen()) return diff(monitor.value(), comparison);
  return restore(monitor.value(), hash, options);
}
