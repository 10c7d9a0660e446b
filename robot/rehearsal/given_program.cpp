#include "robot/rehearsal/given_program.h"

#include <algorithm>
#include <unordered_map>

#include "robot/rehearsal/given_schemas.h"

namespace galilean::robot {
namespace {

const std::string& variable_of(const bhdl::Given& given) noexcept {
  return given.bits_variable.empty() ? given.locate_variable : given.bits_variable;
}

// No text of a program holds a line end, so no schema of it has such a name.
std::string name_of(std::size_t given) {
  return "given\n" + std::to_string(given);
}

bhdl::Component component_of(const bhdl::Given& given, std::size_t number) {
  const bool bits = !given.bits_variable.empty();
  AttributeValues values;
  values.set(bits ? "bits_variable" : "locate_variable", variable_of(given));
  if (bits) {
    values.set("bit_index", static_cast<double>(given.bit_index));
    values.set("bit_value", given.bit_value);
  } else {
    values.set("position", given.position_m);
  }
  values.set("valid", given.valid);
  values.set("from", given.from_s);
  values.set("until", given.until_s);
  return {bits ? kGivenBits : kGivenLocate, name_of(number), ComponentKind::kPerceptualSchema,
          std::move(values), given.location};
}

bool names(const Value& value, const std::string& variable) {
  if (const auto* one = std::get_if<std::string>(&value)) return *one == variable;
  const auto* several = std::get_if<std::vector<std::string>>(&value);
  return several != nullptr && std::ranges::find(*several, variable) != several->end();
}

bool writes(const bhdl::Component& schema, const std::string& variable, const Catalog& catalog) {
  const ComponentSpec* spec = catalog.find(schema.type);
  return spec != nullptr &&
         std::ranges::any_of(spec->attributes, [&](const AttributeSpec& attribute) {
           const Value* value = schema.attributes.find(attribute.name);
           const bool written =
               attribute.access == Access::kWrite || attribute.access == Access::kUpdate;
           return written && value != nullptr && names(*value, variable);
         });
}

using NamesBehind = std::unordered_map<std::string, std::vector<std::string>>;

/// Which givens must be said again behind each schema.
NamesBehind givens_behind(const bhdl::Program& program, const std::vector<bhdl::Given>& givens,
                          const Catalog& catalog) {
  NamesBehind behind;
  for (const auto& schema : program.perceptual_schemas)
    for (std::size_t i = 0; i < givens.size(); ++i)
      if (writes(schema, variable_of(givens[i]), catalog))
        behind[schema.name].push_back(name_of(i));
  return behind;
}

std::vector<std::string> with_names(const std::vector<std::string>& list, std::size_t givens,
                                    const NamesBehind& behind) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < givens; ++i) result.push_back(name_of(i));
  for (const auto& name : list) {
    result.push_back(name);
    if (const auto found = behind.find(name); found != behind.end())
      result.insert(result.end(), found->second.begin(), found->second.end());
  }
  return result;
}

}  // namespace

bhdl::Program with_givens(bhdl::Program program, const bhdl::Expectation& expectation,
                          const Catalog& catalog) {
  const auto behind = givens_behind(program, expectation.givens, catalog);
  for (auto& state : program.states)
    state.perceptual_schemas =
        with_names(state.perceptual_schemas, expectation.givens.size(), behind);
  for (std::size_t i = 0; i < expectation.givens.size(); ++i)
    program.perceptual_schemas.push_back(component_of(expectation.givens[i], i));
  if (!expectation.from_state.empty()) program.start_state = expectation.from_state;
  return program;
}

}  // namespace galilean::robot
