// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { movedBy } from "../../src/map/movable";

it("an arrow key moves a body by 10 cm, up being y", () => {
  expect(movedBy({ x_m: 0.1, y_m: 0.2 }, "ArrowRight")).toEqual({ x_m: 0.2, y_m: 0.2 });
  expect(movedBy({ x_m: 0.2, y_m: 0.2 }, "ArrowUp")).toEqual({ x_m: 0.2, y_m: 0.3 });
  expect(movedBy({ x_m: 0.3, y_m: 0.3 }, "ArrowLeft")).toEqual({ x_m: 0.2, y_m: 0.3 });
  expect(movedBy({ x_m: 0.3, y_m: 0.3 }, "ArrowDown")).toEqual({ x_m: 0.3, y_m: 0.2 });
});

it("no other key does", () => {
  expect(movedBy({ x_m: 0, y_m: 0 }, "Enter")).toBeUndefined();
});
