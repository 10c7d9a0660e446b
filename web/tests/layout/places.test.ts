// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { bordersOf, dropAt, placesOf } from "../../src/layout/places";
import { treeOf } from "../../src/layout/text";

const tree = treeOf("r(25-c(50-a.50-b).75-c)", ["a", "b", "c"])!;

describe("places", () => {
  it("cover the page", () => {
    const boxes = placesOf(tree).map(({ stack, x, y, width, height }) => [stack.shown, x, y, width, height]);
    expect(boxes).toEqual([
      ["a", 0, 0, 0.25, 0.5],
      ["b", 0, 0.5, 0.25, 0.5],
      ["c", 0.25, 0, 0.75, 1],
    ]);
  });

  it("have a border between each two neighbours, which says where it stands", () => {
    const [outer, inner] = bordersOf(tree);
    expect(outer).toMatchObject({ across: "row", path: [], index: 0, x: 0.25, width: 0, height: 1, value: 0.25, between: ["a", "c"] });
    expect(inner).toMatchObject({ across: "column", path: [0], index: 0, y: 0.5, width: 0.25, height: 0, length: 1, between: ["a", "b"] });
  });
});

describe("letting a panel go", () => {
  it("puts it on the side that is near, or as a tab in the middle", () => {
    expect(dropAt(placesOf(tree), 0.99, 0.5)).toMatchObject({ where: "right", box: { x: 0.625, width: 0.375, height: 1 } });
    expect(dropAt(placesOf(tree), 0.12, 0.52)).toMatchObject({ where: "up", target: { stack: { shown: "b" } } });
    expect(dropAt(placesOf(tree), 0.6, 0.5)?.where).toBe("middle");
    expect(dropAt(placesOf(tree), 1.2, 0.5)).toBeUndefined();
  });
});
