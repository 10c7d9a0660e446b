// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/json.h"

#include "bhdl/program/machine.h"
#include "monitor/pushes/history/words.h"

namespace galilean::monitor {
namespace {

nlohmann::json to_json(const msg::Diagnostic& diagnostic) {
  return {{"file", diagnostic.file},     {"line", diagnostic.line},
          {"column", diagnostic.column}, {"severity", diagnostic.severity},
          {"code", diagnostic.code},     {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

}  // namespace

nlohmann::json to_json(const RobotReply& reply) {
  auto diagnostics = nlohmann::json::array();
  for (const auto& diagnostic : reply.reply.diagnostics) diagnostics.push_back(to_json(diagnostic));
  return {{"robot", reply.robot},
          {"status", to_text(reply.status)},
          {"message", reply.reply.message},
          {"hash", reply.reply.hash},
          {"running_hash", reply.reply.running_hash},
          {"diagnostics", std::move(diagnostics)},
          {"kept_variables", reply.reply.kept_variables},
          {"swap_tick_us", reply.reply.swap_tick_us},
          {"latency_ms", reply.latency_ms}};
}

nlohmann::json to_json(const std::vector<RobotReply>& replies) {
  auto json = nlohmann::json::array();
  for (const auto& reply : replies) json.push_back(to_json(reply));
  return json;
}

nlohmann::json to_json(const Step& step) {
  return {{"name", to_text(step.kind)}, {"state", to_text(step.state)}, {"detail", step.detail}};
}

nlohmann::json to_json(const PushRecord& record) {
  auto steps = nlohmann::json::array();
  for (const auto& step : record.progress.steps) steps.push_back(to_json(step));
  nlohmann::json json{{"id", record.id},
                      {"pushed_ns", record.pushed_ns},
                      {"author", record.author},
                      {"program", record.program},
                      {"hash", record.hash},
                      {"targets", record.targets},
                      {"state", to_text(record.progress.state)},
                      {"told_ns", record.progress.told_ns},
                      {"steps", std::move(steps)},
                      {"trial", record.progress.trial},
                      {"replies", to_json(record.replies)}};
  if (!record.not_kept.empty()) json["not_kept"] = record.not_kept;
  return json;
}

nlohmann::json to_json(const OrderRecord& order) {
  auto outcomes = nlohmann::json::array();
  for (const auto& each : order.outcomes)
    outcomes.push_back({{"of", each.of}, {"outcome", each.outcome}, {"told_ns", each.told_ns}});
  return {{"id", order.id},
          {"ordered_ns", order.ordered_ns},
          {"author", order.author},
          {"kind", order.kind},
          {"targets", order.targets},
          {"detail", order.detail},
          {"outcomes", std::move(outcomes)}};
}

nlohmann::json to_json(const bhdl::CheckResult& check) {
  nlohmann::json json{{"ok", check.program.has_value()},
                      {"hash", check.program ? check.program->hash : std::string()},
                      {"diagnostics", check.diagnostics}};
  if (check.program) json["machine"] = *check.program;
  return json;
}

nlohmann::json to_json(const std::vector<bhdl::SourceFile>& files) {
  auto json = nlohmann::json::array();
  for (const auto& file : files) json.push_back({{"path", file.path}, {"text", file.text}});
  return json;
}

Result<std::vector<bhdl::SourceFile>> files_from_json(const nlohmann::json& json,
                                                      const std::string& name) {
  const Error wrong{"'" + name + "' must be a list of {\"path\", \"text\"}, the main file first"};
  if (!json.is_array() || json.empty()) return wrong;
  std::vector<bhdl::SourceFile> files;
  for (const auto& item : json) {
    if (!item.is_object() || !item.contains("path") || !item["path"].is_string() ||
        !item.contains("text") || !item["text"].is_string())
      return wrong;
    files.push_back({item["path"], item["text"]});
  }
  return files;
}

}  // namespace galilean::monitor
