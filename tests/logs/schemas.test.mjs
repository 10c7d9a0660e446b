// SPDX-License-Identifier: BSD-3-Clause
// Every message that leaves a robot must be readable by others from the IDL text that goes with it:
// JavaScript's reference decoder and C++ each read what the other wrote, through DDS.
import assert from "node:assert/strict";
import { createInterface } from "node:readline";
import { after, before, describe, test } from "node:test";
import { within } from "../tools/patience.mjs";
import { MessageReader, MessageWriter, definitionsFor, domain, schemas, start, testTool } from "./tools.mjs";

// A small generator with a seed, so that a failure can be seen again.
function generator(seed) {
  return () => {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    return seed / 2 ** 32;
  };
}

const whole = { uint8: 2 ** 8, uint16: 2 ** 16, uint32: 2 ** 32, int8: 2 ** 7, int16: 2 ** 15, int32: 2 ** 31 };

function randomScalar(type, random) {
  if (type === "bool") return random() < 0.5;
  if (type === "float32") return Math.fround(random() * 200 - 100);
  if (type === "float64") return random() * 2e6 - 1e6;
  if (type === "uint64" || type === "int64") return BigInt(Math.floor(random() * 2 ** 53));
  if (type === "string") return "word ".repeat(Math.floor(random() * 3)) + Math.floor(random() * 1e6);
  if (type in whole) return Math.floor((random() - (type.startsWith("i") ? 0.5 : 0)) * whole[type]);
  throw new Error(`the schema has a ${type}, which ROS 2 does not know`);
}

function randomField(field, definitions, random) {
  const one = () =>
    field.isComplex
      ? randomMessage(definitions.find((d) => d.name === field.type), definitions, random)
      : randomScalar(field.type, random);
  if (!field.isArray) return one();
  const length = field.arrayLength ?? Math.floor(random() * 4);
  return Array.from({ length }, one);
}

function randomMessage(definition, definitions, random) {
  const fields = definition.definitions.filter((field) => !field.isConstant);
  return Object.fromEntries(fields.map((field) => [field.name, randomField(field, definitions, random)]));
}

// ROS 2 calls the nanoseconds nanosec; the decoder calls them nsec.
const isTime = (value) => value && typeof value === "object" && "sec" in value && Object.keys(value).length === 2;

function plain(value) {
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, plain);
  if (isTime(value)) return { sec: value.sec, nsec: value.nsec ?? value.nanosec };
  if (value && typeof value === "object")
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
  return value;
}

describe("messages", () => {
  let echo, answers;
  before(() => {
    echo = start(testTool("wire_echo"), [domain]);
    answers = createInterface({ input: echo.stdout })[Symbol.asyncIterator]();
  });
  after(async () => {
    echo.stdin.end();
    assert.equal((await echo.ended).code, 0, echo.text);
  });

  for (const schema of schemas())
    test(`${schema.ros_type} parses from its own schema text`, () => {
      assert.ok(definitionsFor(schema.ros_type, schema.idl)[0].definitions.length > 0);
    });

  async function throughDds(rosType, bytes) {
    echo.stdin.write(`${rosType} ${Buffer.from(bytes).toString("hex")}\n`);
    const { value: answer } = await within(answers.next(), () => `${rosType} to come back`);
    return Buffer.from(answer, "hex");
  }

  for (const schema of schemas().filter((s) => s.published))
    test(`${schema.ros_type} keeps its values from JavaScript through C++ and DDS and back`, async () => {
      const definitions = definitionsFor(schema.ros_type, schema.idl);
      const random = generator(94);
      const writer = new MessageWriter(definitions);
      const reader = new MessageReader(definitions);
      for (let i = 0; i < 5; ++i) {
        const message = randomMessage(definitions[0], definitions, random);
        const came = await throughDds(schema.ros_type, writer.writeMessage(message));
        assert.deepEqual(plain(reader.readMessage(came)), plain(message));
      }
    });

  test("text beyond ASCII stays whole", async () => {
    const { ros_type, idl } = schemas().find((s) => s.ros_type === "galilean_msgs/msg/RobotState");
    const definitions = definitionsFor(ros_type, idl);
    // The reference encoder counts characters where CDR counts bytes: put the bytes in afterwards.
    const name = Buffer.from("Amälthea – é");
    const stand_in = "?".repeat(name.length);
    const bytes = Buffer.from(new MessageWriter(definitions).writeMessage({ robot: stand_in, problems: [stand_in] }));
    for (let at; (at = bytes.indexOf(stand_in)) >= 0; ) name.copy(bytes, at);
    const came = new MessageReader(definitions).readMessage(await throughDds(ros_type, bytes));
    assert.equal(came.robot, name.toString());
    assert.deepEqual(came.problems, [name.toString()]);
  });
});
