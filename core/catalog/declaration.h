// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/catalog/attribute_values.h"
#include "core/catalog/catalog.h"
#include "core/catalog/wiring.h"
#include "core/random.h"
#include "core/variable/type_name.h"

namespace galilean {

/// The attributes of one component, each declared once. The loader, the checker, the editor and the
/// printed reference all read what `T::describe(Declaration<T>&)` says here.
///
///   static void describe(Declaration<MoveToGoal>& is) {
///     is.help("Pulls the robot towards a located object.");
///     is.reads(&MoveToGoal::goal_, "goal_variable", "what to move to");
///     is.number(&MoveToGoal::success_m_, "success_radius", unit::kCentimetre, 20, "…").range(0,
///     1000); is.writes(&MoveToGoal::result_, "result", "the force");
///   }
///
/// Number members are in SI; defaults and ranges are in the unit that the declaration names.
template <class T>
class Declaration {
 public:
  using Setter = std::function<void(T&, const Value&, const Wiring&)>;

  /// Adds to the attribute that was declared last.
  class Refinement {
   public:
    explicit Refinement(AttributeSpec& spec) : spec_(spec) {}
    Refinement& range(double minimum, double maximum) {
      spec_.minimum = minimum;
      spec_.maximum = maximum;
      return *this;
    }
    Refinement& alias(std::string spelling) {
      spec_.aliases.push_back(std::move(spelling));
      return *this;
    }
    Refinement& count(std::size_t count) {
      spec_.count = count;
      return *this;
    }
    /// Lets a program leave the attribute out. A pointer to a variable is then null.
    Refinement& optional() {
      if (spec_.type == AttributeType::kNames)
        spec_.default_value = Value(std::vector<std::string>{});
      else
        spec_.default_value = Value(std::string{});
      return *this;
    }

    /// Sets the variable's name for programs that do not give it. A variable of that name must
    /// still exist.
    Refinement& default_value(std::string name) {
      spec_.default_value = Value(std::move(name));
      return *this;
    }
    /// Demands of a list that, if it is given, it has as many entries as the list `attribute`.
    Refinement& one_for_each(std::string attribute) {
      spec_.one_for_each = std::move(attribute);
      return *this;
    }
    /// Says that the attribute is read only if the program names something for `attribute`, which
    /// is optional. Otherwise the checker warns.
    Refinement& only_with(std::string attribute) {
      spec_.only_with = std::move(attribute);
      return *this;
    }
    /// Says that the attribute is not read if the program names something for `attribute`, which is
    /// optional. The checker then warns.
    Refinement& only_without(std::string attribute) {
      spec_.only_without = std::move(attribute);
      return *this;
    }
    /// Says of a bit's index that the schema writes that bit of the variable that `attribute`
    /// names. If no attribute says so, the schema counts as writing all bits.
    Refinement& bit_of(std::string attribute) {
      spec_.bit_of = std::move(attribute);
      return *this;
    }
    /// Sets what the attribute means to code that knows no schema by name; see
    /// docs/ADD_A_SCHEMA.md.
    Refinement& role(Role role, std::string of = {}) {
      spec_.role = role;
      spec_.of = std::move(of);
      return *this;
    }

   private:
    AttributeSpec& spec_;
  };

  Declaration(std::string name, ComponentKind kind) {
    spec_.name = std::move(name);
    spec_.kind = kind;
  }

  void help(std::string text) { spec_.help = std::move(text); }

  /// Names the device that the schema commands. One state should not list two schemas that command
  /// the same device.
  void drives(std::string device) { spec_.drives = std::move(device); }

  /// Names a device without which the schema has no effect. The checker warns of a program that
  /// lists the schema and does not name the device. A robot drives no program that lists the schema
  /// while the device is silent.
  void needs(std::string device) { spec_.needs.push_back(std::move(device)); }

  /// Names the robot's device that these settings are for.
  void configures(std::string device) { spec_.configures = std::move(device); }

  Refinement flag(bool T::*member, std::string name, bool default_value, std::string text) {
    return add({.name = std::move(name),
                .type = AttributeType::kFlag,
                .default_value = Value(default_value),
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring&) { t.*member = std::get<bool>(v); });
  }
  template <class N>
  Refinement number(N T::*member, std::string name, Unit unit, double default_value,
                    std::string text) {
    return number_attribute(member, std::move(name), unit, Value(default_value), std::move(text));
  }
  /// Adds a number that every program must give.
  template <class N>
  Refinement required_number(N T::*member, std::string name, Unit unit, std::string text) {
    return number_attribute(member, std::move(name), unit, std::nullopt, std::move(text));
  }
  Refinement pair(Vec2 T::*member, std::string name, Unit unit, Vec2 default_value,
                  std::string text) {
    return add({.name = std::move(name),
                .type = AttributeType::kPair,
                .unit = unit,
                .default_value = Value(default_value),
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring&) { t.*member = std::get<Vec2>(v); });
  }
  Refinement numbers(std::vector<double> T::*member, std::string name, Unit unit,
                     std::vector<double> default_value, std::string text) {
    return add({.name = std::move(name),
                .type = AttributeType::kNumbers,
                .unit = unit,
                .default_value = Value(std::move(default_value)),
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring&) {
                 t.*member = std::get<std::vector<double>>(v);
               });
  }
  Refinement text(std::string T::*member, std::string name, std::string default_value,
                  std::string help_text) {
    return add(
        {.name = std::move(name),
         .type = AttributeType::kText,
         .default_value = Value(std::move(default_value)),
         .help = std::move(help_text)},
        [member](T& t, const Value& v, const Wiring&) { t.*member = std::get<std::string>(v); });
  }
  /// Requires: the member is an enum whose values count up from 0 in the order of `choices`, or a
  /// bool.
  template <class E>
  Refinement choice(E T::*member, std::string name, std::vector<std::string> choices,
                    std::string default_value, std::string help_text) {
    AttributeSpec spec{.name = std::move(name),
                       .type = AttributeType::kChoice,
                       .default_value = Value(std::move(default_value)),
                       .choices = choices,
                       .help = std::move(help_text)};
    return add(std::move(spec),
               [member, choices = std::move(choices)](T& t, const Value& v, const Wiring&) {
                 const auto& word = std::get<std::string>(v);
                 for (std::size_t i = 0; i < choices.size(); ++i)
                   if (choices[i] == word) t.*member = static_cast<E>(i);
               });
  }

  template <class V>
  Refinement reads(const Variable<V>* T::*member, std::string name, std::string text) {
    return variable(member, std::move(name), Access::kRead, std::move(text));
  }
  template <class V>
  Refinement writes(Variable<V>* T::*member, std::string name, std::string text) {
    return variable(member, std::move(name), Access::kWrite, std::move(text));
  }
  /// Adds a variable that the schema reads and writes.
  template <class V>
  Refinement updates(Variable<V>* T::*member, std::string name, std::string text) {
    return variable(member, std::move(name), Access::kUpdate, std::move(text));
  }
  template <class V>
  Refinement reads_all(std::vector<const Variable<V>*> T::*member, std::string name,
                       std::string text) {
    return add({.name = std::move(name),
                .type = AttributeType::kNames,
                .refers_to = variable_type_name<V>(),
                .access = Access::kRead,
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring& wiring) {
                 for (const auto& each : std::get<std::vector<std::string>>(v))
                   (t.*member).push_back(wiring.variables.find<V>(each));
               });
  }

  /// Adds a list of names of variables of any type. The schema gets their reliabilities.
  Refinement adjusts(std::vector<Reliability*> T::*member, std::string name, std::string text) {
    return add({.name = std::move(name),
                .type = AttributeType::kNames,
                .refers_to = "variable",
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring& wiring) {
                 for (const auto& each : std::get<std::vector<std::string>>(v))
                   if (Reliability* found = wiring.variables.find_reliability(each))
                     (t.*member).push_back(found);
               });
  }

  /// Adds the gain, which every motor schema takes. The executive multiplies by it; the schema does
  /// not know it.
  void takes_gain() {
    add({.name = kGainAttribute,
         .type = AttributeType::kNumber,
         .default_value = Value(1.0),
         .help = "what its force is multiplied by"},
        [](T&, const Value&, const Wiring&) {})
        .range(0, 1e6);
  }

  /// These two add no attribute. They give the component the robot's devices, or its own stream of
  /// random numbers.
  void uses_devices(const Devices* T::*member) {
    uses_devices_ = true;
    connections_.push_back([member](T& t, const Wiring& wiring) { t.*member = &wiring.devices; });
  }
  void uses_random(Random T::*member) {
    connections_.push_back([member](T& t, const Wiring& wiring) { t.*member = wiring.random; });
  }

  [[nodiscard]] const ComponentSpec& spec() const noexcept { return spec_; }

  /// Errors: throws std::logic_error if the component gets the robot's devices and names none that
  /// it needs.
  void require_named_devices() const {
    if (uses_devices_ && spec_.needs.empty())
      throw std::logic_error("'" + spec_.name +
                             "' uses the robot's devices, but does not say which it needs");
  }

  /// Sets every attribute that `values` gives, then the devices and random numbers. Requires: the
  /// checker has filled in the defaults.
  void apply(T& target, const AttributeValues& values, const Wiring& wiring) const {
    for (std::size_t i = 0; i < setters_.size(); ++i)
      if (const Value* value = values.find(spec_.attributes[i].name))
        setters_[i](target, *value, wiring);
    for (const auto& connect : connections_) connect(target, wiring);
  }

 private:
  Refinement add(AttributeSpec spec, Setter setter) {
    spec_.attributes.push_back(std::move(spec));
    setters_.push_back(std::move(setter));
    return Refinement(spec_.attributes.back());
  }
  template <class N>
  Refinement number_attribute(N T::*member, std::string name, Unit unit,
                              std::optional<Value> default_value, std::string text) {
    constexpr auto type =
        std::is_floating_point_v<N> ? AttributeType::kNumber : AttributeType::kInteger;
    return add({.name = std::move(name),
                .type = type,
                .unit = unit,
                .default_value = std::move(default_value),
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring&) {
                 t.*member = static_cast<N>(std::get<double>(v));
               });
  }
  template <class Pointer>
  Refinement variable(Pointer T::*member, std::string name, Access access, std::string text) {
    using V = std::remove_cv_t<std::remove_pointer_t<Pointer>>;
    using Content = decltype(V::value);
    return add({.name = std::move(name),
                .type = AttributeType::kName,
                .refers_to = variable_type_name<Content>(),
                .access = access,
                .help = std::move(text)},
               [member](T& t, const Value& v, const Wiring& wiring) {
                 t.*member = wiring.variables.find<Content>(std::get<std::string>(v));
               });
  }

  ComponentSpec spec_;
  std::vector<Setter> setters_;
  std::vector<std::function<void(T&, const Wiring&)>> connections_;
  bool uses_devices_ = false;
};

}  // namespace galilean
