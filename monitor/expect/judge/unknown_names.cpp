// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/judge/unknown_names.h"

#include <vector>

#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "monitor/expect/judge/needs.h"

namespace galilean::expect {
namespace {

std::string meant_of(std::string_view name, const std::set<std::string>& known) {
  return meant_name(name, std::vector<std::string_view>(known.begin(), known.end()));
}

std::string behind_a_sentence(const std::string& meant) {
  return meant.empty() ? "" : "; " + bhdl::did_you_mean(meant).text;
}

}  // namespace

std::string unknown_name(const std::string& robot, std::string_view kind, const std::string& name,
                         const std::set<std::string>& known) {
  return robot + " has no " + std::string(kind) + " " + bhdl::in_quotes(name) +
         behind_a_sentence(meant_of(name, known));
}

std::string meant_robot(std::string_view robot, const std::set<std::string>& heard) {
  return behind_a_sentence(meant_of(robot, heard));
}

std::string meant_topic(const TopicName& topic, const std::string& robot,
                        const std::set<std::string>& heard) {
  const std::string name = topic.of(robot);
  const std::string owner(robot_of(name));
  if (owner.empty() || heard.contains(owner)) return {};
  if (topic.relative()) return meant_robot(owner, heard);
  const auto meant = meant_of(owner, heard);
  return meant.empty() ? "" : behind_a_sentence("/" + meant + name.substr(1 + owner.size()));
}

}  // namespace galilean::expect
