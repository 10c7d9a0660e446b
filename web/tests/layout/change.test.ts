// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { beside, grown, moved, opened, resized, stacked, without } from "../../src/layout/change";
import { textOf, treeOf } from "../../src/layout/text";
import type { Node } from "../../src/layout/tree";

const KNOWN = ["a", "b", "c", "d", "e"];
const tree = (text: string): Node => treeOf(text, KNOWN)!;
const text = (node: Node | undefined) => node && textOf(node);

describe("an arrangement as text", () => {
  it("comes back as it went", () => {
    for (const written of ["a", "r(30-a.70-b)", "r(33'3-c(50-a.50-b~c*).66'7-d)"]) expect(text(tree(written))).toBe(written);
  });

  it("leaves out panels that are unknown or told twice, and the rows that they leave empty", () => {
    expect(text(tree("r(30-c(50-a.50-gone).40-a.30-b)"))).toBe("r(50-a.50-b)");
  });

  it("is none where the text is damaged", () => {
    for (const damaged of ["", "r(", "r(30-a", "r(a.b)", "r(30-a)x", "r(0-a.1-b)"]) expect(treeOf(damaged, KNOWN)).toBeUndefined();
  });
});

describe("closing and opening", () => {
  it("gives a closed panel's room to its neighbours", () => {
    expect(text(without(tree("r(50-a.25-b.25-c)"), "a"))).toBe("r(50-b.50-c)");
    expect(text(without(tree("r(50-a.50-c(50-b.50-c))"), "b"))).toBe("r(50-a.50-c)");
    expect(without(tree("a"), "a")).toBeUndefined();
  });

  it("shows the next tab where the shown one is closed", () => {
    expect(text(without(tree("a~b*~c"), "b"))).toBe("a~c");
  });

  it("brings a panel back behind the one it belongs to, or as the only one", () => {
    expect(text(opened(tree("r(50-a.50-b)"), "c", "a"))).toBe("r(50-a~c*.50-b)");
    expect(text(opened(undefined, "c", "a"))).toBe("c");
  });
});

describe("putting a panel elsewhere", () => {
  it("halves the room of what it stands beside", () => {
    expect(text(beside(tree("r(40-a.60-b)"), "b", "a", "up"))).toBe("c(50-a.50-b)");
    expect(text(beside(tree("r(40-a.60-c(50-b.50-c))"), "c", "a", "right"))).toBe("c(50-b.50-r(50-c.50-a))");
  });

  it("takes a tab out of its stack", () => {
    expect(text(beside(tree("a~b"), "a", "a", "left"))).toBe("r(50-a.50-b)");
  });

  it("makes tabs", () => {
    expect(text(stacked(tree("r(50-a.50-b)"), "b", "a"))).toBe("b~a*");
  });

  it("never loses a panel by putting it on itself", () => {
    expect(text(stacked(tree("r(50-a.50-b)"), "a", "a"))).toBe("r(50-a.50-b)");
    expect(text(beside(tree("a"), "a", "a", "left"))).toBe("a");
  });
});

describe("moving by one step", () => {
  it("goes past its neighbour, each with its own size", () => {
    expect(text(moved(tree("r(30-a.70-b)"), "a", "right"))).toBe("r(70-b.30-a)");
  });

  it("leaves its column for the side of it", () => {
    expect(text(moved(tree("r(50-a.50-c(50-b.50-c))"), "c", "right"))).toBe("r(50-a.37'5-b.12'5-c)");
  });

  it("goes to the page's edge where nothing lies that way", () => {
    expect(text(moved(tree("r(50-a.50-b)"), "a", "down"))).toBe("c(75-b.25-a)");
  });

  it("stays where it is already at the edge", () => {
    expect(text(moved(tree("r(50-a.50-b)"), "a", "left"))).toBe("r(50-a.50-b)");
  });

  it("takes a tab out first", () => {
    expect(text(moved(tree("a~b*"), "b", "down"))).toBe("c(50-a.50-b)");
  });

  it("reaches every order of three panels by steps", () => {
    const seen = new Set<string>();
    const waiting = ["r(33'3-a.33'3-b.33'3-c)"];
    const order = (written: string) => written.replace(/[\d'.-]+/g, " ");
    for (let at = waiting.pop(); at !== undefined && seen.size < 500; at = waiting.pop()) {
      if (seen.has(order(at))) continue;
      seen.add(order(at));
      for (const panel of ["a", "b", "c"])
        for (const side of ["left", "right", "up", "down"] as const) waiting.push(textOf(moved(tree(at), panel, side)));
    }
    for (const wanted of ["r( c b a)", "c( b a c)", "c( a r( b c))", "r( c( a b) c)"]) expect([...seen]).toContain(wanted);
  });
});

describe("resizing", () => {
  it("takes from one neighbour what it gives the other, down to the least", () => {
    expect(text(resized(tree("r(30-a.30-b.40-c)"), [], 0, 0.1))).toBe("r(40-a.20-b.40-c)");
    expect(text(resized(tree("r(30-a.30-b.40-c)"), [], 0, -0.9))).toBe("r(8-a.52-b.40-c)");
  });

  it("grows a panel in the direction asked for, however deep it stands", () => {
    const before = tree("r(50-c(50-a.50-b).50-c)");
    expect(text(grown(before, "a", "row", 0.1))).toBe("r(60-c(50-a.50-b).40-c)");
    expect(text(grown(before, "b", "column", 0.1))).toBe("r(50-c(40-a.60-b).50-c)");
    expect(text(grown(before, "c", "column", 0.1))).toBe("r(50-c(50-a.50-b).50-c)");
  });
});
