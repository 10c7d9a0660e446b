// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/json.h"

#include "bhdl/program/machine.h"

namespace galilean::monitor {
namespace {

nlohmann::json to_json(const msg::Diagnostic& diagnostic) {
  return {{"file", diagnostic.file},     {"line", diagnostic.line},
          {"column", diagnostic.column}, {"severity", diagnostic.severity},
          {"code", diagnostic.code},     {"message", diagnostic.message},
          {"hint", diagnostic.hint}};
}

}  // namespace

nlohmann::json to_json(const PushAnswer& answer) {
  auto diagnostics = nlohmann::json::array();
  for (const auto& diagnostic : answer.reply.diagnostics)
    diagnostics.push_back(to_json(diagnostic));
  return {{"robot", answer.robot},
          {"status", answer.status},
          {"message", answer.reply.message},
          {"hash", answer.reply.hash},
          {"running_hash", answer.reply.running_hash},
          {"diagnostics", std::move(diagnostics)},
          {"kept_variables", answer.reply.kept_variables},
          {"swap_tick_us", answer.reply.swap_tick_us},
          {"latency_ms", answer.latency_ms}};
}

nlohmann::json to_json(const std::vector<PushAnswer>& answers) {
  auto json = nlohmann::json::array();
  for (const auto& answer : answers) json.push_back(to_json(answer));
  return json;
}

nlohmann::json to_json(const SwapStep& step) {
  return {{"name", step.name}, {"state", step.state}, {"detail", step.detail}};
}

nlohmann::json to_json(const PushRecord& record) {
  auto steps = nlohmann::json::array();
  for (const auto& step : record.progress.steps) steps.push_back(to_json(step));
  return {{"id", record.id},
          {"pushed_ns", record.pushed_ns},
          {"author", record.author},
          {"program", record.program},
          {"hash", record.hash},
          {"targets", record.targets},
          {"state", record.progress.state},
          {"steps", std::move(steps)},
          {"trial", record.progress.trial_json.empty()
                        ? nlohmann::json()
                        : nlohmann::json::parse(record.progress.trial_json, nullptr, false)},
          {"replies", to_json(record.answers)}};
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
