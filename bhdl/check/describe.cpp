// SPDX-License-Identifier: BSD-3-Clause
#include "bhdl/check/describe.h"

#include <algorithm>
#include <array>

#include "bhdl/check/expectation_specs.h"
#include "bhdl/check/state_specs.h"
#include "bhdl/check/vocabulary.h"
#include "bhdl/program/value_words.h"
#include "bhdl/source/names.h"
#include "bhdl/source/text.h"
#include "bhdl/syntax/keywords.h"

namespace galilean::bhdl {
namespace {

constexpr std::array kKinds{ComponentKind::kInputDevice, ComponentKind::kOutputDevice,
                            ComponentKind::kVariable, ComponentKind::kPerceptualSchema,
                            ComponentKind::kMotorSchema};

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width + 2), ' ');
  return text;
}

template <class Specs>
std::size_t widest_name(const Specs& specs) {
  std::size_t width = 0;
  for (const auto& spec : specs) width = std::max(width, spec.name.size());
  return width;
}

std::string first_sentence(const std::string& help) {
  const auto end = help.find(". ");
  return end == std::string::npos ? help : help.substr(0, end + 1);
}

std::string default_in_words(const AttributeSpec& spec) {
  if (spec.required()) return "must be given";
  const std::string value = value_in_words(*spec.default_value);
  if (value.empty() || value == "\"\"") return "may be left out";
  return "default " + value_in_words(*spec.default_value, spec.unit);
}

std::string use_in_words(Access access) {
  switch (access) {
    case Access::kRead:
      return "; reads it";
    case Access::kWrite:
      return "; writes it";
    case Access::kUpdate:
      return "; reads and writes it";
    default:
      return {};
  }
}

}  // namespace

std::string facts_in_words(const AttributeSpec& spec) {
  std::string text = expectation(spec) + use_in_words(spec.access) + "; " + default_in_words(spec);
  if (const auto range = range_in_words(spec); !range.empty()) text += "; " + range;
  for (const auto& alias : spec.aliases) text += "; also spelt " + alias;
  return text;
}

namespace {

std::string attribute_in_words(const AttributeSpec& spec, std::size_t width) {
  return "  " + padded(spec.name + ":", width + 1) + facts_in_words(spec) + "\n" +
         std::string(width + 5, ' ') + spec.help + "\n";
}

std::string component_in_words(const ComponentSpec& spec, std::string_view kind) {
  std::string text =
      spec.name + (kind.empty() ? "" : ", a") + std::string(kind) + "\n  " + spec.help + "\n";
  if (!spec.attributes.empty()) text += "\n";
  for (const auto& attribute : spec.attributes)
    text += attribute_in_words(attribute, widest_name(spec.attributes));
  return text;
}

std::string kind_with_article(ComponentKind kind) {
  const auto words = kind_in_words(kind);
  return (words.starts_with('i') || words.starts_with('o') ? "n " : " ") + std::string(words);
}

/// Returns the catalog's components, then states, conditions, expectations and their steps.
Catalog with_language(const Catalog& catalog) {
  Catalog all{Vocabulary(catalog).components()};
  all.components.push_back(state_spec());
  all.components.push_back(condition_spec());
  all.components.push_back(expect_spec());
  for (const auto& step : step_specs()) all.components.push_back(step);
  return all;
}

Error unknown(const Catalog& all, std::string_view component) {
  const auto hint = did_you_mean(nearest(component, names_of(all.components)));
  return {"there is no component " + in_quotes(component) +
          (hint.text.empty() ? "" : "; " + hint.text)};
}

}  // namespace

std::string describe(const Catalog& catalog) {
  const std::size_t width = widest_name(catalog.components);
  std::string text;
  for (const auto kind : kKinds) {
    text += std::string(section_word(kind)) + ":\n";
    for (const auto& component : catalog.components)
      if (component.kind == kind)
        text += "  " + padded(component.name, width) + first_sentence(component.help) + "\n";
    text += "\n";
  }
  text += "states:\n";
  for (const auto* spec : {&state_spec(), &condition_spec()})
    text += "  " + padded(spec->name, width) + first_sentence(spec->help) + "\n";
  text += "\nexpectations:\n  " + padded(expect_spec().name, width) +
          first_sentence(expect_spec().help) + "\n";
  for (const auto& step : step_specs())
    text += "  " + padded(step.name, width) + first_sentence(step.help) + "\n";
  return text + "\n`galilean bhdl describe COMPONENT` tells what one of them takes.\n";
}

Result<std::string> describe(const Catalog& catalog, std::string_view component) {
  if (component == state_spec().name) return component_in_words(state_spec(), {});
  if (component == condition_spec().name) return component_in_words(condition_spec(), {});
  if (component == expect_spec().name) return component_in_words(expect_spec(), {});
  for (const auto& step : step_specs())
    if (component == step.name) return component_in_words(step, {});
  const Catalog all = with_language(catalog);
  const ComponentSpec* spec = all.find(component);
  if (spec == nullptr) return unknown(all, component);
  return component_in_words(*spec, kind_with_article(spec->kind));
}

Result<std::string> describe_json(const Catalog& catalog, std::string_view component) {
  if (component.empty()) return catalog_to_json(catalog);
  const Catalog all = with_language(catalog);
  const ComponentSpec* spec = all.find(component);
  if (spec == nullptr) return unknown(all, component);
  return catalog_to_json(Catalog{{*spec}});
}

}  // namespace galilean::bhdl
