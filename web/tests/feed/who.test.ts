// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { introduction, nameOperator, operatorName, takeClient, takeName } from "../../src/feed/who";

function storeOf(entries: Record<string, string> = {}) {
  const kept = new Map(Object.entries(entries));
  return { getItem: (key: string) => kept.get(key) ?? null, setItem: (key: string, value: string) => void kept.set(key, value) };
}

it("a tab keeps its id, and another tab has another", () => {
  const tab = storeOf();
  const id = takeClient(tab);
  expect(id).toMatch(/^[0-9a-f]{16}$/);
  expect(takeClient(tab)).toBe(id);
  expect(takeClient(storeOf())).not.toBe(id);
});

it("a new tab takes the name that was typed last in this browser", () => {
  const browser = storeOf({ "galilean.operator": "Ada" });
  expect(takeName(storeOf(), browser)).toBe("Ada");
  expect(takeName(storeOf({ "galilean.operator": "Ben" }), browser)).toBe("Ben");
  expect(takeName(storeOf(), storeOf())).toBe("");
});

it("a name goes as a header can carry it, and none where none was typed", () => {
  expect(introduction()).not.toHaveProperty("x-galilean-operator");
  nameOperator("  Zoë ");
  expect(operatorName()).toBe("Zoë");
  expect(introduction()["x-galilean-operator"]).toBe("Zo%C3%AB");
  nameOperator("");
});
