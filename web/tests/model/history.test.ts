// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { History } from "../../src/model/history";
import { emptyTeam } from "../../src/model/model";
import { robotOf, state, T0_MS, told } from "./told";

it("gives the team as it was at an instant, for ten minutes back", () => {
  const history = new History();
  for (let second = 0; second <= 700; second += 1) {
    const at_ms = T0_MS + second * 1000;
    history.record(told([["/io/state", state({ at_ms, state: `state${second}` }), at_ms]]), at_ms);
  }
  const shown = (second: number) => robotOf(history.at(T0_MS + second * 1000)!.team).state?.value.state;
  expect(shown(650)).toBe("state650");
  expect(shown(650.7)).toBe("state650");
  expect(shown(3)).toBe("state100");
});

it("keeps each half second of the last two minutes, and each two seconds of what is older", () => {
  const history = new History();
  for (let at_ms = T0_MS; at_ms <= T0_MS + 1_200_000; at_ms += 100) history.record(emptyTeam, at_ms);
  const steps_ms = history.instants.map(({ at_ms }, i, all) => at_ms - (all[i - 1]?.at_ms ?? at_ms)).slice(1);
  expect(steps_ms.filter((step_ms) => step_ms === 500).length).toBe(240);
  expect(steps_ms.filter((step_ms) => step_ms === 2000).length).toBe(240);
  expect(steps_ms.length).toBe(480);
});
