// The page's message types against the project's own IDL: a field that is renamed there breaks here.
import { readFileSync } from "node:fs";
import { parseRos2idl } from "@foxglove/ros2idl-parser";
import { describe, expect, it } from "vitest";
import { decoderOf } from "../../src/feed/decoder";
import { schemaOf, writerOf } from "../fixture/idl.mjs";

const source = readFileSync(new URL("../../src/feed/messages.ts", import.meta.url), "utf8");
const packages = ["galilean_msgs", "nav_msgs", "sensor_msgs", "rcl_interfaces"];
const declared = new Map(
  packages
    .flatMap((name) => parseRos2idl(schemaOf(`${name}/msg/Any`)))
    .map(({ name = "", definitions }) => [name.split("/").at(-1)!, definitions.map((field) => field.name)] as const),
);

const interfaces = [...source.matchAll(/export interface (\w+)(?: extends \w+)? \{\n((?: {2}.*\n)+)\}/g)];
const shared = interfaces.filter(([, name]) => declared.has(name!) && name !== "Time");

describe("the messages that the page reads", () => {
  it.each(shared.map(([, name, body]) => [name!, body!] as const))("%s has the IDL's fields", (name, body) => {
    const fields = [...body.matchAll(/^ {2}(\w+):/gm)].map((match) => match[1]!);
    expect(declared.get(name)).toEqual(expect.arrayContaining(fields));
  });
  it("are found at all", () => expect(shared.length).toBeGreaterThan(15));
});

describe("decoding", () => {
  it("reads the bytes that the IDL's encoding gives", () => {
    const type = "galilean_msgs/msg/Transition";
    const message = { stamp: { sec: 5, nsec: 6 }, robot: "io", number: 7n, to_state: "grab_trash", line: 12, bit_value: true, reset_variables: ["trash"] };
    const decoded = decoderOf(type, schemaOf(type))(writerOf(type)(message));
    expect(decoded).toMatchObject(message);
  });
  it("says which type a schema fails to declare", () => {
    expect(() => decoderOf("a/msg/B", "module a { module msg { struct C { long x; }; }; };")).toThrow("a/msg/B");
  });
});
