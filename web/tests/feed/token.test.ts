// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { takeToken } from "../../src/feed/token";

function storage(kept?: string) {
  const items = new Map(kept ? [["galilean.token", kept]] : []);
  return { getItem: (key: string) => items.get(key) ?? null, setItem: (key: string, value: string) => void items.set(key, value) };
}

describe("the token", () => {
  it("comes with the link, is kept, and leaves the address bar", () => {
    const kept = storage();
    const shown: string[] = [];
    const place = { hash: "#token=abc", pathname: "/", search: "?x=1" };
    expect(takeToken(place, kept, (address) => shown.push(address))).toBe("abc");
    expect(shown).toEqual(["/?x=1"]);
    expect(takeToken({ ...place, hash: "" }, kept, () => shown.push("again"))).toBe("abc");
    expect(shown).toHaveLength(1);
  });
  it("is empty where nobody gave one", () => {
    expect(takeToken({ hash: "#elsewhere", pathname: "/", search: "" }, storage(), () => {})).toBe("");
  });
});
