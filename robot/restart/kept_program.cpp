// SPDX-License-Identifier: BSD-3-Clause
#include "robot/restart/kept_program.h"

#include <system_error>
#include <utility>

#include "bhdl/source/sha256.h"
#include "core/cut_text.h"
#include "core/json_text.h"
#include "core/private_file.h"
#include "core/regular_file.h"
#include "core/visible_text.h"

namespace galilean::robot {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFormat = "galilean robot, version 1";
constexpr std::uintmax_t kMostBytes = 32 << 20;

std::string json_of(const KeptProgram& kept) {
  json files = json::array();
  for (const auto& file : kept.files) files.push_back({{"path", file.path}, {"text", file.text}});
  return json_text({{"format", kFormat},
                    {"robot", kept.robot},
                    {"running", kept.running},
                    {"pushed", kept.pushed},
                    {"hash", kept.hash},
                    {"held_by", kept.orders.held_by},
                    {"out_of_service", kept.orders.out_of_service},
                    {"files", std::move(files)}});
}

/// Errors: a field is missing or of another type.
Result<KeptProgram> kept_in(const json& text) try {
  KeptProgram kept;
  if (text.at("format").get<std::string>() != kFormat) return Error{"it has another format"};
  kept.robot = text.at("robot").get<std::string>();
  kept.running = text.at("running").get<bool>();
  kept.pushed = text.at("pushed").get<bool>();
  kept.hash = text.at("hash").get<std::string>();
  for (const json& file : text.at("files"))
    kept.files.push_back({file.at("path").get<std::string>(), file.at("text").get<std::string>()});
  // Files of builds before this one have no orders.
  const std::string held_by = visible(text.value("held_by", std::string()));
  kept.orders.held_by = cut_text(held_by, KeptOrders::kMostHolderBytes);
  kept.orders.out_of_service = text.value("out_of_service", false);
  return kept;
} catch (const json::exception&) {
  return Error{"it has another format"};
}

Result<KeptProgram> parse(const std::string& text, const std::string& robot) {
  const auto read = read_untrusted_json(text);
  if (!read) return Error{"it is cut short or no JSON"};
  auto kept = kept_in(read.value());
  if (!kept) return kept;
  if (kept.value().robot != robot) return Error{"it is of another robot"};
  if (kept.value().files.empty() || bhdl::program_hash(kept.value().files) != kept.value().hash)
    return Error{"its program does not match its hash"};
  return kept;
}

}  // namespace

fs::path kept_program_file(const fs::path& state_folder, const std::string& robot,
                           std::uint32_t domain) {
  return state_folder / "robots" / ("domain_" + std::to_string(domain)) / (robot + ".json");
}

Result<std::optional<KeptProgram>> read_kept_program(const fs::path& file,
                                                     const std::string& robot) {
  std::error_code unknown;
  if (fs::symlink_status(file, unknown).type() == fs::file_type::not_found)
    return std::optional<KeptProgram>();
  const auto text = read_regular_file(file.string(), kMostBytes);
  if (!text) return Error{file.string() + " cannot be read: " + text.error().message};
  auto kept = parse(text.value(), robot);
  if (!kept) return Error{file.string() + " is not what this robot kept: " + kept.error().message};
  return std::optional<KeptProgram>(std::move(kept).value());
}

Result<void> write_kept_program(const fs::path& file, const KeptProgram& kept) {
  (void)make_private_folder(file.parent_path());  // what fails is said when the file is written
  return replace_private_file(file, json_of(kept));
}

}  // namespace galilean::robot
