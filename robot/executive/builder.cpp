// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/builder.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "robot/executive/snapshot.h"
#include "robot/variables/settings.h"

namespace galilean::robot {
namespace {

/// The exception that carries an error from deep inside to build's result.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Refusal refusal(const bhdl::Component& component, const std::string& reason) {
  const auto& at = component.location;
  return Refusal(at.file + ":" + std::to_string(at.line) + ": " + component.type + " '" +
                 component.name + "' " + reason);
}

template <class T, class Settings>
void add_variable(RunningProgram& program, const bhdl::Component& component, const Wiring& wiring) {
  const auto given = settings<Settings>(component.attributes, wiring);
  Variable<T>& variable = program.variables.add<T>(component.name);
  if constexpr (requires { given.content(); }) variable.value = given.content();
  variable.reliability = given.reliability();
  if constexpr (std::is_same_v<T, Shaft>) program.start_poses.push_back(variable.value.pose);
}

struct VariableMaker {
  std::string_view type;
  void (*add)(RunningProgram&, const bhdl::Component&, const Wiring&);
};
constexpr std::array<VariableMaker, 5> kVariableMakers{{
    {variable_type_name<Shaft>(), add_variable<Shaft, ShaftSettings>},
    {variable_type_name<Image>(), add_variable<Image, ImageSettings>},
    {variable_type_name<Locate>(), add_variable<Locate, LocateSettings>},
    {variable_type_name<Bits>(), add_variable<Bits, BitsSettings>},
    {variable_type_name<Force>(), add_variable<Force, ForceSettings>},
}};

/// Returns the names that an attribute holds, whether it takes one or several.
std::vector<std::string> names_in(const AttributeSpec& spec, const AttributeValues& values) {
  const Value* value = values.find(spec.name);
  if (!value) return {};
  if (const auto* several = std::get_if<std::vector<std::string>>(value)) return *several;
  if (const auto* one = std::get_if<std::string>(value); one && !one->empty()) return {*one};
  return {};
}

/// Returns one gain for each input. A single number is the gain of all inputs.
std::vector<double> gains_in(const Value* value, std::size_t inputs) {
  if (value == nullptr) return {};
  if (const auto* one = std::get_if<double>(value)) return std::vector<double>(inputs, *one);
  return std::get<std::vector<double>>(*value);
}

class Builder {
  using Indices = std::unordered_map<std::string_view, std::uint32_t>;

 public:
  Builder(bhdl::Program text, ProgramId id, const BuildMaterial& material)
      : material_(material), made_(std::make_unique<RunningProgram>()) {
    description_.id = id;
    description_.probation = material.probation;
    description_.program = std::move(text);
  }

  std::unique_ptr<RunningProgram> build() {
    made_->devices = DeviceSettings::of(text(), material_.components.catalog());
    for (const auto& component : text().variables) make_variable(component);
    for (const auto& component : text().perceptual_schemas) make_schema(component, perceptual_);
    for (const auto& component : text().motor_schemas) make_schema(component, motor_);
    for (const auto& state : text().states) states_.emplace(state.name, states_.size());
    for (const auto& state : text().states) make_state(state);
    made_->start_state = made_->state = index(states_, text().start_state, "state");
    describe_variables();
    describe_gains();
    check_size();
    made_->description = std::make_shared<const Description>(std::move(description_));
    return std::move(made_);
  }

 private:
  [[nodiscard]] const bhdl::Program& text() const { return description_.program; }
  [[nodiscard]] Wiring wiring_of(const bhdl::Component& component) {
    return {made_->variables, material_.devices, material_.random.child(component.name)};
  }

  void make_variable(const bhdl::Component& component) {
    const auto maker = std::ranges::find(kVariableMakers, component.type, &VariableMaker::type);
    if (maker == kVariableMakers.end())
      throw refusal(component, "is of a type that this robot's variables do not have");
    maker->add(*made_, component, wiring_of(component));
    // No schema writes a shaft, but dead reckoning does.
    if (Variable<Shaft>* shaft = made_->variables.find<Shaft>(component.name)) note_written(shaft);
  }

  /// Notes that something writes the variable. It then fades and is no parameter.
  void note_written(VariableRef variable) {
    std::visit(
        [this](auto* each) {
          each->constant = false;
          written_.insert(each->name);
        },
        variable);
  }

  void make_schema(const bhdl::Component& component, Indices& indices) {
    const ComponentSpec* spec = material_.components.catalog().find(component.type);
    auto schema =
        material_.components.make(component.type, component.attributes, wiring_of(component));
    if (!schema || !spec) throw refusal(component, "is not a schema of this robot");
    const Value* gain = component.attributes.find(kGainAttribute);
    indices.emplace(component.name, made_->schemas.size());
    made_->schemas.emplace_back(std::move(schema), outputs_of(component, *spec),
                                gain ? std::get<double>(*gain) : 1);
    description_.schemas.push_back(component.name);
  }

  std::vector<VariableRef> outputs_of(const bhdl::Component& component, const ComponentSpec& spec) {
    std::vector<VariableRef> outputs;
    for (const auto& attribute : spec.attributes) {
      if (attribute.access != Access::kWrite && attribute.access != Access::kUpdate) continue;
      for (const auto& name : names_in(attribute, component.attributes)) {
        const VariableRef output = variable(name);
        note_written(output);
        outputs.push_back(output);
        describe_output(component, attribute, output);
      }
    }
    return outputs;
  }

  void describe_output(const bhdl::Component& component, const AttributeSpec& attribute,
                       const VariableRef& output) {
    const std::size_t runner = made_->schemas.size();
    if (const auto* force = std::get_if<Variable<Force>*>(&output))
      description_.forces.push_back({component.name, (*force)->name, 1, runner});
    const auto* image = std::get_if<Variable<Image>*>(&output);
    if (image == nullptr || attribute.role != Role::kChannel) return;
    const auto& images = made_->variables.all<Image>();
    const auto at = std::ranges::find(images, *image, [](const auto& each) { return &each; });
    description_.images.push_back({attribute.of, static_cast<std::size_t>(at - images.begin())});
  }

  void make_state(const bhdl::State& state) {
    RunningState& made = made_->states.emplace_back();
    for (const auto& name : state.perceptual_schemas)
      made.perceptual_schemas.push_back(index(perceptual_, name, "perceptual schema"));
    for (const auto& name : state.motor_schemas)
      made.motor_schemas.push_back(index(motor_, name, "motor schema"));
    for (const auto& condition : state.conditions)
      made.conditions.push_back(make_condition(condition));
  }

  RunningCondition make_condition(const bhdl::Condition& condition) {
    RunningCondition made{.bits = made_->variables.find<Bits>(condition.bits_variable),
                          .bit_index = condition.bit_index,
                          .bit_value = condition.bit_value,
                          .bit_update = condition.bit_update,
                          .new_state = index(states_, condition.new_state, "state")};
    if (!made.bits) throw Refusal("no bits variable is named '" + condition.bits_variable + "'");
    if (condition.bit_update != bhdl::BitUpdate::kSame) written_.insert(condition.bits_variable);
    for (const auto& name : condition.reset_variables) {
      made.reset_variables.push_back(variable(name));
      written_.insert(name);
    }
    return made;
  }

  VariableRef variable(const std::string& name) {
    if (const auto found = find_variable(made_->variables, name)) return *found;
    throw Refusal("no variable is named '" + name + "'");
  }
  static std::uint32_t index(const Indices& indices, const std::string& name, const char* what) {
    const auto found = indices.find(name);
    if (found == indices.end())
      throw Refusal(std::string("no ") + what + " is named '" + name + "'");
    return found->second;
  }

  void describe_variables() {
    made_->variables.for_each([&]<class T>(const Variable<T>& each) {
      const bool parameter = !written_.contains(each.name);
      description_.variables.push_back({each.name, variable_type_name<T>(), parameter});
    });
  }

  /// Copies the gains that schemas give to their inputs, so that viewers can draw each force as it
  /// counts.
  void describe_gains() {
    for (const auto& component : text().motor_schemas)
      for (const auto& attribute : material_.components.catalog().find(component.type)->attributes)
        if (attribute.role == Role::kGain) describe_gains(component, attribute);
  }
  void describe_gains(const bhdl::Component& component, const AttributeSpec& attribute) {
    const ComponentSpec& spec = *material_.components.catalog().find(component.type);
    const auto inputs = names_in(*spec.find(attribute.of), component.attributes);
    const auto gains = gains_in(component.attributes.find(attribute.name), inputs.size());
    for (auto& force : description_.forces)
      for (std::size_t i = 0; i < std::min(inputs.size(), gains.size()); ++i)
        if (inputs[i] == force.variable) force.gain = gains[i];
  }

  void check_size() const {
    if (description_.variables.size() > Snapshot::kMostVariables)
      throw Refusal("the program has " + std::to_string(description_.variables.size()) +
                    " variables; at most " + std::to_string(Snapshot::kMostVariables) +
                    " can be shown");
    if (description_.forces.size() > Snapshot::kMostForces)
      throw Refusal("the program has " + std::to_string(description_.forces.size()) +
                    " schemas that write forces; at most " + std::to_string(Snapshot::kMostForces) +
                    " can be shown");
  }

  const BuildMaterial& material_;
  std::unique_ptr<RunningProgram> made_;
  Description description_;
  Indices perceptual_;  ///< among all schemas; a motor schema may have the same name
  Indices motor_;
  Indices states_;
  std::unordered_set<std::string_view> written_;
};

}  // namespace

Result<std::unique_ptr<RunningProgram>> build(bhdl::Program program, ProgramId id,
                                              const BuildMaterial& material) {
  try {
    return Builder(std::move(program), id, material).build();
  } catch (const std::exception& problem) {
    return Error{problem.what()};
  }
}

}  // namespace galilean::robot
