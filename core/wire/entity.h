// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>

namespace galilean::wire {

/// Owns an entity of Cyclone. The entity is deleted with this object.
class Entity {
 public:
  Entity() = default;
  explicit Entity(std::int32_t handle) noexcept : handle_(handle) {}
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Entity();
  [[nodiscard]] std::int32_t handle() const noexcept { return handle_; }

 private:
  std::int32_t handle_ = 0;
};

}  // namespace galilean::wire
