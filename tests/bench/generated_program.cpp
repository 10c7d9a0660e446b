// SPDX-License-Identifier: BSD-3-Clause
#include "tests/bench/generated_program.h"

#include <array>
#include <nlohmann/json.hpp>

namespace galilean::bhdl {
namespace {

constexpr const char* kParts = R"(input_devices:
  comm_port: end
end

output_devices:
  motor_drive: end
end

variables:
  shaft:  name: "shaft"  status: "valid"  certainty: 1
  bits:   name: "bumpers"
  locate: name: "obstacle"  class: "obstacle"  memory: 10
  force:  name: "noise"
  force:  name: "away"
  force:  name: "next_move"
end

perceptual_schemas:
  bumper_scanner: name: "bumper_scanner"  bits_variable: "bumpers"  end
  obstacle_detector:
    name: "front_bumper"
    bits_variable: "bumpers"  bit_index: 0  shaft_variable: "shaft"
    translation: <0, 27>
    obstacle_variable: "obstacle"
  end
  obstacle_detector:
    name: "left_bumper"
    bits_variable: "bumpers"  bit_index: 1  shaft_variable: "shaft"
    translation: <-18, 24>
    obstacle_variable: "obstacle"
  end
end

motor_schemas:
  noise: name: "noise"  shaft_variable: "shaft"  persistence: 5  result: "noise"  end
  avoid_obstacle:
    name: "avoid"
    shaft_variable: "shaft"  obstacle_variable: "obstacle"
    max_repulsion: 3
    result: "away"
  end
  combine_forces: name: "combine"  inputs: "noise" "away"  gains: 1 1  result: "next_move"  end
  move_robot:
    name: "move"
    input_force: "next_move"  shaft_variable: "shaft"  mask_variable: "bumpers"
  end
end

states:
)";

std::string state_name(int number) {
  return "state_" + std::to_string(number);
}

constexpr std::array<int, 3> kSteps{1, 7, 41};

}  // namespace

std::string generated_program(int states) {
  std::string text = kParts;
  for (int i = 0; i < states; ++i) {
    text += "  state:\n    name: \"" + state_name(i) +
            "\"\n    perceptual_schemas: \"bumper_scanner\" \"front_bumper\" \"left_bumper\" end\n"
            "    motor_schemas: \"noise\" \"avoid\" \"combine\" \"move\" end\n";
    for (const int step : kSteps)
      text += "    condition: bits_variable: \"bumpers\"  bit_index: " + std::to_string(step % 8) +
              "  bit_value: 1  new_state: \"" + state_name((i + step) % states) + "\"  end\n";
    text += "  end\n\n";
  }
  return text + "end\n";
}

std::string generated_json(int states) {
  nlohmann::json all = nlohmann::json::array();
  for (int i = 0; i < states; ++i) {
    nlohmann::json state{{"name", state_name(i)},
                         {"perceptual_schemas", {"bumper_scanner", "front_bumper", "left_bumper"}},
                         {"motor_schemas", {"noise", "avoid", "combine", "move"}}};
    for (const int step : kSteps)
      state["conditions"].push_back({{"bits_variable", "bumpers"},
                                     {"bit_index", step % 8},
                                     {"bit_value", 1},
                                     {"new_state", state_name((i + step) % states)}});
    all.push_back(std::move(state));
  }
  return all.dump(1);
}

}  // namespace galilean::bhdl
