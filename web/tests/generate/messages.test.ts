// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { commentsOf } from "../../generate/comments.mjs";
import { packages, textOf } from "../../generate/idl.mjs";
import { messagesModule } from "../../generate/messages.mjs";
import { moduleOf } from "../../generate/typescript.mjs";

const IDL = `#ifndef A_IDL
#define A_IDL
// Of the whole file.
#include "b.idl"
module a { module msg {

  // Values of Shot.kind
  module Shot_Constants {
    const uint8 NEAR = 1;          // closer than 1 m
    const uint8 FAR = 2;
  };
  // rt/shot: one shot.
  // Reliable.
  @final struct Shot {
    unsigned long long tick;       // since the start
    uint8 kind;                    // see Shot_Constants
    double x_m; double y_m;        // map frame
    sequence<double> values;
    sequence<string> names;
    sequence<boolean> hits;
    sequence<Point> points;
    double covariance[4];
    // Above its field,
    // in two lines.
    octet level;
  };
  @final struct Point { double x; }; // in metres
}; };
#endif
`;
const WITHOUT_INCLUDE = IDL.replace(/^#.*$/gm, "");
const moduleFrom = (schema: string, text = schema) => moduleOf([{ name: "a", schema, text }]);

describe("the module made of an IDL", () => {
  it("declares each type as it is decoded, with the comments that the IDL has", () => {
    expect(moduleFrom(WITHOUT_INCLUDE, IDL)).toBe(`/** Values of Shot.kind */
export const Shot_Constants = {
  /** closer than 1 m */
  NEAR: 1,
  FAR: 2,
} as const;
export type Shot_Constants = (typeof Shot_Constants)[keyof typeof Shot_Constants];

/**
 * rt/shot: one shot.
 * Reliable.
 */
export interface Shot {
  /** since the start */
  tick: bigint;
  /** see Shot_Constants */
  kind: Shot_Constants;
  /** map frame */
  x_m: number;
  /** map frame */
  y_m: number;
  values: Float64Array;
  names: string[];
  hits: boolean[];
  points: Point[];
  covariance: Float64Array;
  /**
   * Above its field,
   * in two lines.
   */
  level: number;
}

/** in metres */
export interface Point {
  x: number;
}

/** What is decoded, by the name that a channel gives its schema. */
export interface Messages {
  "a/msg/Shot": Shot;
  "a/msg/Point": Point;
}
`);
  });
  it("is refused for a type that the decoder cannot read, with its file", () => {
    expect(() => moduleFrom("module a { module msg { struct B { wstring x; }; }; };")).toThrow(/a\.idl: error: B\.x: the page cannot read the type wstring/);
  });
  it("is refused for a text that is no IDL, with its file", () => {
    expect(() => moduleFrom("module a { struct")).toThrow(/^core\/wire\/idl\/a\.idl: error: /);
  });
  it("is refused for two types of one name", () => {
    const files = ["a", "b"].map((name) => ({ name, schema: `module ${name} { module msg { struct C { long x; }; }; };`, text: "" }));
    expect(() => moduleOf(files)).toThrow("b/msg/C and a/msg/C have one name in TypeScript");
  });
});

describe("the comments of an IDL", () => {
  it("tell of the file apart from its types", () => expect(commentsOf(IDL).get("")).toBe("Of the whole file."));
  const module = messagesModule();
  it.each(packages())("of %s all come into the module", (name) => {
    const text = textOf(name);
    const body = text.slice(text.indexOf("module msg {"));
    const comments = [...body.matchAll(/\/\/ (.*)/g)].map((match) => match[1]!.trim());
    expect(comments.filter((comment) => !module.includes(comment))).toEqual([]);
  });
});
