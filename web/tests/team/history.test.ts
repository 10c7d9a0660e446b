import { expect, it } from "vitest";
import { History } from "../../src/team/history";
import { robotOf, state, T0_MS, told } from "./told";

it("gives the team as it was at an instant, for ten minutes back", () => {
  const history = new History();
  for (let second = 0; second <= 700; second += 1) {
    const at_ms = T0_MS + second * 1000;
    history.record(told([["/io/state", state({ at_ms, state: `state${second}` }), at_ms]]), at_ms);
  }
  const shown = (second: number) => robotOf(history.at(T0_MS + second * 1000)!).state?.value.state;
  expect(shown(650)).toBe("state650");
  expect(shown(650.7)).toBe("state650");
  expect(shown(3)).toBe("state100");
});
