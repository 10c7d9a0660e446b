#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace galilean::monitor {

/// What an operation comes to: an HTTP status and its JSON; of a failure, `detail` says why in one
/// sentence and `json` has what goes with it.
struct Outcome {
  int status = 200;
  nlohmann::json json = nlohmann::json::object();
  std::string detail = {};
};
using Finish = std::function<void(Outcome)>;

}  // namespace galilean::monitor
