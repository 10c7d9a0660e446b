// SPDX-License-Identifier: BSD-3-Clause
import { expect, it } from "vitest";
import { type Identity, identityOf } from "../../src/model/identity";

function identities(names: string[]): Identity[] {
  return names.reduce<Identity[]>((others, name) => [...others, identityOf(name, others)], []);
}

it("gives thirty robots thirty letters, and no two neighbours the same look", () => {
  const all = identities(Array.from({ length: 30 }, (_, i) => `robot${i + 1}`));
  expect(new Set(all.map(({ letter }) => letter)).size).toBe(30);
  expect(new Set(all.map(({ colour, shape }) => colour + shape)).size).toBe(30);
});

it("knows the paper's robots however late they come", () => {
  const [, io] = identities(["callisto", "io"]);
  expect(io).toMatchObject({ index: 0, letter: "I" });
});
