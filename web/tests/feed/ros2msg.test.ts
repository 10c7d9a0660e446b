// SPDX-License-Identifier: BSD-3-Clause
import { describe, expect, it } from "vitest";
import { messagesModule } from "../../generate/messages.mjs";
import { decoderOf } from "../../src/feed/decoder";
import { parseRos2msg } from "../../src/feed/ros2msg";
import { declaredIn } from "../fixture/declared";
import { messageFileOf, schemaOf, writerOf } from "../fixture/idl.mjs";

const types = [...(declaredIn(messagesModule()).interfaces.get("Messages")?.keys() ?? [])];

describe("a recording's schemas", () => {
  it.each(types)("%s is decoded as it is live", (type) => {
    const bytes = writerOf(type)({});
    expect(decoderOf(type, messageFileOf(type), "ros2msg")(bytes)).toEqual(decoderOf(type, schemaOf(type))(bytes));
  });
  it("may be those of .msg files, with all that these may have", () => {
    const text = 'uint8 NEAR=1 # a constant\nstring KIND = "a"\nHeader header\nfloat32[3] corner   # of the box\nint16[] counts\nstring<=5 unit "m"\nReading[<=2] readings\nbyte letter\r\n===\nMSG: a_msgs/Reading\nbool valid\n';
    expect(parseRos2msg("a_msgs/msg/Scan", text)).toEqual([
      {
        name: "a_msgs/msg/Scan",
        definitions: [
          { name: "header", type: "std_msgs/msg/Header", isComplex: true },
          { name: "corner", type: "float32", isComplex: false, isArray: true, arrayLength: 3 },
          { name: "counts", type: "int16", isComplex: false, isArray: true },
          { name: "unit", type: "string", isComplex: false },
          { name: "readings", type: "a_msgs/msg/Reading", isComplex: true, isArray: true },
          { name: "letter", type: "uint8", isComplex: false },
        ],
      },
      { name: "a_msgs/msg/Reading", definitions: [{ name: "valid", type: "bool", isComplex: false }] },
    ]);
  });
  it("that make no sense are told of by the line", () => {
    expect(() => parseRos2msg("a_msgs/msg/Scan", "float32\n")).toThrow("its schema has the line “float32”, which defines no field");
  });
});
