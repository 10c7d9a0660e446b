// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/front/manual/places.h"

#include <algorithm>
#include <filesystem>

#include "core/installation.h"

namespace galilean::front {
namespace {

constexpr int kEndless = 1000;

/// Adds the options of `outer` that `own` does not have itself. --help is each command's own.
void add_outer_options(const std::vector<OptionDescription>& outer,
                       std::vector<OptionDescription>& own) {
  for (const auto& option : outer) {
    const bool is_there =
        std::ranges::any_of(own, [&](const auto& other) { return other.names == option.names; });
    if (!is_there) own.push_back(option);
  }
}

void add_place(const CommandDescription& command, const std::string& path,
               const std::vector<OptionDescription>& outer_options, std::vector<Place>& places) {
  Place place;
  place.path = path;
  for (const auto& option : command.options)
    (option.names.empty() ? place.arguments : place.options).push_back(option);
  if (command.takes_outer_options) add_outer_options(outer_options, place.options);
  for (const auto& inner : command.commands) place.commands.push_back(&inner);
  const auto options = place.options;
  places.push_back(std::move(place));
  for (const auto& inner : command.commands)
    add_place(inner, path + (path.empty() ? "" : " ") + last_word(inner.name), options, places);
}

std::vector<std::string> shipped_names(const ValueFiles& files) {
  std::vector<std::string> names;
  if (files.shipped.empty()) return names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(shipped(files.shipped), ignored))
    if (entry.path().extension() == files.extension) names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::vector<Place> places_of(const CommandDescription& tree) {
  std::vector<Place> places;
  add_place(tree, "", {}, places);
  return places;
}

std::string last_word(const std::string& name) {
  return name.substr(name.rfind(' ') + 1);
}

bool is_endless(const OptionDescription& option) {
  return option.most_values >= kEndless;
}

std::vector<std::string> words_for(const OptionDescription& option) {
  auto words = option.choices;
  words.insert(words.end(), option.examples.begin(), option.examples.end());
  const auto names = shipped_names(option.files);
  words.insert(words.end(), names.begin(), names.end());
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string quoted(const std::string& text, const std::string& quote, const std::string& special) {
  std::string result = "'";
  for (const char c : text) {
    if (special.find(c) != special.npos) result += '\\';
    if (c == '\'')
      result += quote;
    else
      result += c;
  }
  return result + "'";
}

}  // namespace galilean::front
