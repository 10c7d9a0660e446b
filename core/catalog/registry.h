// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/catalog/declaration.h"
#include "core/schema/schema.h"

namespace galilean {

/// The components that a robot is built from. One explicit list fills it (robot/components.cpp). It
/// makes schemas. It only describes variables and devices, since the store and the robot own them.
class Registry {
 public:
  /// Adds a schema. Requires: T has `static void describe(Declaration<T>&)`. Errors: throws
  /// std::logic_error if an attribute cannot have its role, or if T uses devices and needs none.
  template <class T>
  void add_schema(std::string name) {
    constexpr auto kind = std::is_base_of_v<MotorSchema, T> ? ComponentKind::kMotorSchema
                                                            : ComponentKind::kPerceptualSchema;
    auto declaration = std::make_shared<Declaration<T>>(name, kind);
    T::describe(*declaration);
    if constexpr (kind == ComponentKind::kMotorSchema) declaration->takes_gain();
    require_sound_roles(declaration->spec());
    declaration->require_named_devices();
    catalog_.components.push_back(declaration->spec());
    factories_[std::move(name)] = [declaration](const AttributeValues& values,
                                                const Wiring& wiring) {
      auto schema = std::make_unique<T>();
      declaration->apply(*schema, values, wiring);
      return schema;
    };
  }
  /// Adds a device or a variable, whose settings `settings<T>` reads. Requires and Errors: as
  /// add_schema.
  template <class T>
  void add_settings(std::string name, ComponentKind kind) {
    Declaration<T> declaration(std::move(name), kind);
    T::describe(declaration);
    require_sound_roles(declaration.spec());
    catalog_.components.push_back(declaration.spec());
  }

  [[nodiscard]] const Catalog& catalog() const noexcept { return catalog_; }

  /// Returns a new schema, or nullptr if no schema has that name. The checker refuses such
  /// programs.
  [[nodiscard]] std::unique_ptr<Schema> make(std::string_view name, const AttributeValues& values,
                                             const Wiring& wiring) const {
    const auto found = factories_.find(name);
    return found == factories_.end() ? nullptr : found->second(values, wiring);
  }

 private:
  using Factory = std::function<std::unique_ptr<Schema>(const AttributeValues&, const Wiring&)>;

  Catalog catalog_;
  std::map<std::string, Factory, std::less<>> factories_;
};

/// Returns the settings of a device or a variable as the program gives them.
template <class T>
[[nodiscard]] T settings(const AttributeValues& values, const Wiring& wiring) {
  static const Declaration<T> declaration = [] {
    Declaration<T> described({}, ComponentKind::kVariable);
    T::describe(described);
    return described;
  }();
  T result;
  declaration.apply(result, values, wiring);
  return result;
}

}  // namespace galilean
