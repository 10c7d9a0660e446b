// SPDX-License-Identifier: BSD-3-Clause
#include "robot/executive/program_intake.h"

#include <utility>

namespace galilean::robot {
namespace {

constexpr std::size_t kDescriptionsKept = 16;

}  // namespace

Result<ProgramId> ProgramIntake::load(bhdl::Program program, const BuildMaterial& material) {
  const std::lock_guard lock(mutex_);
  exchange_.collect();
  if (exchange_.waiting()) return Error{"another program still waits for its first tick"};
  auto built = build(std::move(program), last_id_ + 1, material);
  if (!built) return built.error();
  descriptions_[++last_id_] = built.value()->description;
  forget_old_descriptions();
  exchange_.offer(std::move(built).value());
  return last_id_;
}

bool ProgramIntake::order_rollback(const RollbackOrder& order) {
  const std::lock_guard lock(mutex_);
  return orders_.push(order);
}

/// Drops the oldest descriptions. One that a living program or a caller still holds stays, however
/// old it is.
void ProgramIntake::forget_old_descriptions() {
  for (auto each = descriptions_.begin();
       descriptions_.size() > kDescriptionsKept && each != descriptions_.end();)
    each = each->second.use_count() == 1 ? descriptions_.erase(each) : std::next(each);
}

void ProgramIntake::collect() {
  const std::lock_guard lock(mutex_);
  exchange_.collect();
}

std::shared_ptr<const Description> ProgramIntake::description(ProgramId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = descriptions_.find(id);
  return found == descriptions_.end() ? nullptr : found->second;
}

}  // namespace galilean::robot
