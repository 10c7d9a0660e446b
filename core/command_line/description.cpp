// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/description.h"

#include <nlohmann/json.hpp>

#include "core/json_text.h"

namespace galilean {

NLOHMANN_JSON_SERIALIZE_ENUM(ValueFiles::Kind, {{ValueFiles::Kind::kNone, "none"},
                                                {ValueFiles::Kind::kFile, "file"},
                                                {ValueFiles::Kind::kFolder, "folder"}})

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ValueFiles, kind, extension, shipped)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OptionDescription, names, argument, help, value, range,
                                   default_value, choices, examples, files, required, least_values,
                                   most_values)

void to_json(nlohmann::json& json, const CommandDescription& command) {
  json = {{"name", command.name},
          {"help", command.help},
          {"footer", command.footer},
          {"takes_outer_options", command.takes_outer_options},
          {"requires_command", command.requires_command},
          {"options", command.options},
          {"commands", command.commands},
          {"exit_codes", command.exit_codes}};
}

void from_json(const nlohmann::json& json, CommandDescription& command) {
  json.at("name").get_to(command.name);
  json.at("help").get_to(command.help);
  json.at("footer").get_to(command.footer);
  json.at("takes_outer_options").get_to(command.takes_outer_options);
  json.at("requires_command").get_to(command.requires_command);
  json.at("options").get_to(command.options);
  json.at("commands").get_to(command.commands);
  json.at("exit_codes").get_to(command.exit_codes);
}

std::string description_to_json(const CommandDescription& command) {
  return json_text(nlohmann::json(command));
}

Result<CommandDescription> description_from_json(const std::string& text) try {
  const auto json = read_json(text);
  if (!json) return Error{"it is no description of a command line: " + json.error().message};
  return json.value().get<CommandDescription>();
} catch (const nlohmann::json::exception& problem) {
  return Error{std::string("it is no description of a command line: ") + problem.what()};
}

}  // namespace galilean
