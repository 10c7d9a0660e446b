// SPDX-License-Identifier: BSD-3-Clause
#include "core/wire/generate/bounds.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace galilean::idl {
namespace {

/// One line of the file, in words, and where it stands.
struct Line {
  std::string place;
  bool is_indented;
  std::vector<std::string> words;

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(place + ": error: " + what);
  }
};

std::vector<Line> lines_of(const std::string& name, const std::string& text) {
  std::vector<Line> lines;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line.substr(0, line.find('#')));
    Line read{name + ".bounds:" + std::to_string(number), line.starts_with(' '), {}};
    for (std::string word; words >> word;) read.words.push_back(word);
    if (!read.words.empty()) lines.push_back(std::move(read));
  }
  return lines;
}

/// Returns the text as it was, if it is a number.
std::string number(const Line& line, const std::string& text) {
  try {
    std::size_t used = 0;
    static_cast<void>(std::stod(text, &used));
    if (used == text.size()) return text;
  } catch (const std::exception&) {
    // It is told below.
  }
  line.fail("'" + text + "' is not a number");
}

FieldBounds parse_field(const Line& line) {
  FieldBounds field;
  const auto& words = line.words;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto word = [&](std::size_t at) { return at < words.size() ? words[at] : std::string(); };
    if (words[i] == "any") {
      field.any = true;
    } else if (words[i] == "own_name") {
      field.name = FieldBounds::Name::kOwn;
    } else if (words[i] == "robot_name") {
      field.name = FieldBounds::Name::kRobot;
    } else if (words[i] == "robot_name_or_empty") {
      field.name = FieldBounds::Name::kRobotOrEmpty;
    } else if (words[i] == "most") {
      field.most = std::stol(number(line, word(++i)));
    } else if (word(i + 1) == "..") {
      field.low = number(line, words[i]);
      field.high = number(line, word(i + 2));
      i += 2;
    } else {
      line.fail(
          "'" + words[i] +
          "' is none of any, own_name, robot_name, robot_name_or_empty, most N and LOW .. HIGH");
    }
  }
  return field;
}

const Struct* find_struct(const File& file, const std::string& name) {
  const auto found = std::find_if(file.structs.begin(), file.structs.end(),
                                  [&](const Struct& type) { return type.name == name; });
  return found == file.structs.end() ? nullptr : &*found;
}

bool has_field(const Struct& type, const std::string& name) {
  return std::any_of(type.fields.begin(), type.fields.end(),
                     [&](const Field& field) { return field.name == name; });
}

}  // namespace

void parse_bounds(const File& file, const std::string& text, AllBounds& all) {
  const Struct* type = nullptr;
  for (const Line& line : lines_of(file.name, text)) {
    const std::string& name = line.words.front();
    if (!line.is_indented) {
      type = find_struct(file, name);
      if (!type) line.fail(file.name + ".idl declares no struct '" + name + "'");
      all[type->module + "::" + name];
    } else if (!type || !has_field(*type, name)) {
      line.fail("'" + name + "' is no field of the struct above it");
    } else {
      all[type->module + "::" + type->name][name] = parse_field(line);
    }
  }
  for (const Struct& each : file.structs)
    if (!all.contains(each.module + "::" + each.name))
      throw std::runtime_error(file.name + ".bounds: error: " + each.name +
                               " has no bounds; add a line '" + each.name +
                               "', and under it its fields whose bounds differ from the defaults");
}

}  // namespace galilean::idl
