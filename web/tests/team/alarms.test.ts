import { expect, it } from "vitest";
import { alarms } from "../../src/team/alarms";
import { state, T0_MS, told } from "./told";

it("tells of silence and of what a robot complains of", () => {
  const team = told([
    ["/io/state", state({ problems: ["frame_grabber: no picture for 2 s"] }), T0_MS],
    ["/ganymede/state", state({ robot: "ganymede" }), T0_MS - 9000],
  ]);
  expect(alarms(team, T0_MS)).toEqual(["io: frame_grabber: no picture for 2 s", "ganymede is silent."]);
});
