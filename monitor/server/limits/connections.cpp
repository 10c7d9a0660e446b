// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/limits/connections.h"

#include <algorithm>
#include <utility>

namespace galilean::monitor {

Connections::Place::Place(std::shared_ptr<Connections> all, std::string address, bool is_reserved)
    : all_(std::move(all)), address_(std::move(address)), is_reserved_(is_reserved) {
  if (!is_reserved_) ++all_->open_of_[address_];
  if (is_reserved_) ++all_->reserved_;
  ++all_->open_;
}

Connections::Place::~Place() {
  serve();
  let_go();
  --all_->open_;
  if (is_reserved_) {
    --all_->reserved_;
    return;
  }
  const auto of_address = all_->open_of_.find(address_);
  if (--of_address->second == 0) all_->open_of_.erase(of_address);
}

void Connections::Place::wait(std::function<void()> close) {
  serve();
  turn_ = all_->waiting_.insert(all_->waiting_.end(), this);
  waits_ = true;
  close_ = std::move(close);
}

void Connections::Place::serve() {
  if (std::exchange(waits_, false)) all_->waiting_.erase(turn_);
  close_ = nullptr;
}

void Connections::Place::in_turn(std::function<void()> work) const {
  if (!all_->in_turn_) return work();
  all_->in_turn_(std::move(work));
}

bool Connections::Place::keep(std::size_t bytes) {
  read_bytes_ += bytes;
  if (read_bytes_ <= kFreeBytes) return true;
  const std::size_t more = read_bytes_ - kFreeBytes - kept_bytes_;
  if (all_->kept_bytes_ + more > all_->limits_.messages_bytes) {
    all_->counts_->reached(Limit::kMessages);
    return false;
  }
  kept_bytes_ += more;
  all_->kept_bytes_ += more;
  return true;
}

void Connections::Place::let_go() {
  all_->kept_bytes_ -= std::exchange(kept_bytes_, 0);
  read_bytes_ = 0;
}

std::shared_ptr<Connections::Place> Connections::admit(const std::string& address,
                                                       bool is_loopback) {
  const auto of_address = open_of_.find(address);
  const std::size_t its = of_address == open_of_.end() ? 0 : of_address->second;
  const auto most = is_loopback ? limits_.connections_of_loopback : limits_.connections_of_address;
  const bool address_is_full = its >= most;
  const bool is_full = open_ - reserved_ >= limits_.connections;
  if (address_is_full) counts_->reached(Limit::kConnectionsOfAddress);
  if (is_full) counts_->reached(Limit::kConnections);
  bool is_reserved = false;
  if (address_is_full || is_full)
    is_reserved = !make_room(address_is_full ? &address : nullptr, false);
  // A reserved connection waits, too, until its first request has come.
  if (is_reserved && reserved_ >= limits_.reserved_connections && !make_room(nullptr, true))
    return nullptr;
  return std::make_shared<Place>(shared_from_this(), address, is_reserved);
}

bool Connections::close_waiting() {
  return make_room(nullptr, false) || make_room(nullptr, true);
}

/// Closes the connection that has waited longest, of those from `address` if it is not null.
/// Returns whether there was one. Its place may outlive the call by a moment, which is not counted
/// anew.
bool Connections::make_room(const std::string* address, bool is_reserved) {
  const auto oldest = std::find_if(waiting_.begin(), waiting_.end(), [&](const Place* place) {
    return place->is_reserved_ == is_reserved && (!address || place->address_ == *address);
  });
  if (oldest == waiting_.end()) return false;
  ++closed_for_others_;
  const auto close = std::exchange((*oldest)->close_, nullptr);
  (*oldest)->serve();
  if (close) close();
  return true;
}

}  // namespace galilean::monitor
