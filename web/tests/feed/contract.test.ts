// SPDX-License-Identifier: BSD-3-Clause
// The message types that are made of the project's own IDL, against what the page's decoder gives.
import { readFileSync } from "node:fs";
import { parseRos2idl } from "@foxglove/ros2idl-parser";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import { describe, expect, it } from "vitest";
import { messagesModule } from "../../generate/messages.mjs";
import { decoderOf } from "../../src/feed/decoder";
import { declaredIn, misfits } from "../fixture/declared";
import { constantsOf, schemaOf, writerOf } from "../fixture/idl.mjs";

const module = messagesModule();
const declared = declaredIn(module);
const types = [...(declared.interfaces.get("Messages") ?? [])];

/** A message with something in each field and two elements in each sequence. */
function sampleOf(type: string): Record<string, unknown> {
  const definitions = parseRos2idl(schemaOf(type));
  const message = (name: string): Record<string, unknown> => {
    const fields = definitions.find((definition) => definition.name === name)?.definitions ?? [];
    return Object.fromEntries(fields.map((field) => {
      const one = () => (field.isComplex ? message(field.type) : scalar(field.type));
      return [field.name, field.isArray ? Array.from({ length: field.arrayLength ?? 2 }, one) : one()];
    }));
  };
  return message(type);
}

function scalar(type: string): unknown {
  if (type === "string") return "a";
  if (type === "bool") return true;
  return type.endsWith("int64") ? 1n : 1;
}

const decoded = (type: string, message: object): unknown => decoderOf(type, schemaOf(type))(writerOf(type)(message));

describe("the types of messages", () => {
  it.each(types)("%s is what is decoded", (type, name) => {
    expect(misfits(declared, name, decoded(type, sampleOf(type)), name)).toEqual([]);
  });
  it("are those of the whole IDL", () => {
    expect(types.map(([type]) => type)).toEqual(expect.arrayContaining(["galilean_msgs/msg/Score", "nav_msgs/msg/OccupancyGrid", "rcl_interfaces/msg/Log"]));
    expect(types.length).toBeGreaterThan(40);
  });
  it("have the kinds of break points that docs/openapi.yaml lists", () => {
    const description = readFileSync(new URL("../../../docs/openapi.yaml", import.meta.url), "utf8");
    const listed = /^ {4}BreakPoint:$[^]*?\bkind: \{ enum: \[([^\]]+)\]/m.exec(description)?.[1]?.split(", ");
    expect(listed).toEqual(Object.keys(constantsOf("galilean_msgs/msg/BreakPoint")));
  });
  it("stand in the module that the page imports", () => {
    expect(readFileSync(new URL("../../src/feed/messages.ts", import.meta.url), "utf8")).toBe(module);
  });
});

describe("holding values against the types", () => {
  const message = decoded("galilean_msgs/msg/Variables", sampleOf("galilean_msgs/msg/Variables")) as { tick: unknown; items: Record<string, unknown>[] };
  it.each([
    ["a number for a bigint", { ...message, tick: 1 }, "Variables.tick is a number, not a bigint"],
    ["a field too many", { ...message, extra: 1 }, "Variables.extra is not declared"],
    ["a field too few", { ...message, robot: undefined }, "Variables.robot is a undefined, not a string"],
    ["numbers for a typed array", { ...message, items: [{ ...message.items[0], values: [1] }] }, "Variables.items[0].values is a Array, not a Float64Array"],
    ["no value of the constants", { ...message, items: [{ ...message.items[0], type: 9 }] }, "Variables.items[0].type is 9, not a value of Variable_Constants"],
  ])("finds %s", (_, value, misfit) => {
    const strings = { ...value, robot: "robot" in value ? value.robot : undefined };
    expect(misfits(declared, "Variables", strings, "Variables")).toEqual([misfit]);
  });
});

describe("decoding", () => {
  it("reads the bytes that the IDL's encoding gives", () => {
    const message = { stamp: { sec: 5, nsec: 6 }, robot: "io", number: 7n, to_state: "grab_trash", line: 12, bit_value: true, reset_variables: ["trash"] };
    expect(decoded("galilean_msgs/msg/Transition", message)).toMatchObject(message);
  });
  it("says which type a schema fails to declare", () => {
    expect(() => decoderOf("a/msg/B", "module a { module msg { struct C { long x; }; }; };")).toThrow("a/msg/B");
  });
});

describe("the fixture's writer of CDR", () => {
  it.each(types)("gives the bytes of %s that Foxglove's own gives", (type) => {
    const definitions = parseRos2idl(schemaOf(type));
    const others = definitions.filter(({ name }) => name !== type);
    const theirs = new MessageWriter([...definitions.filter(({ name }) => name === type), ...others]).writeMessage(sampleOf(type));
    expect(Buffer.from(writerOf(type)(sampleOf(type))).toString("hex")).toBe(Buffer.from(theirs).toString("hex"));
  });
  it("counts the bytes of a letter, and not the letters", () => {
    expect(decoded("galilean_msgs/msg/RobotState", { robot: "Jó", state: "grab_trash" })).toMatchObject({ robot: "Jó", state: "grab_trash" });
  });
  it("writes 0 and nothing where a message has no value", () => {
    expect(decoded("galilean_msgs/msg/RobotState", {})).toMatchObject({ stamp: { sec: 0, nsec: 0 }, robot: "", tick: 0n, held: false, problems: [] });
  });
});
