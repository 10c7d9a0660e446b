// SPDX-License-Identifier: BSD-3-Clause
// TypeScript of IDL types: what the page's decoder makes of their encoding.
import { parseRos2idl } from "@foxglove/ros2idl-parser";
import { commentsOf } from "./comments.mjs";

const NUMBERS = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"];
const VALUES = new Map([...NUMBERS.map((type) => [type, "number"]), ["int64", "bigint"], ["uint64", "bigint"], ["bool", "boolean"], ["string", "string"]]);
const ARRAYS = new Map([
  ["int8", "Int8Array"], ["uint8", "Uint8Array"], ["int16", "Int16Array"], ["uint16", "Uint16Array"],
  ["int32", "Int32Array"], ["uint32", "Uint32Array"], ["int64", "BigInt64Array"], ["uint64", "BigUint64Array"],
  ["float32", "Float32Array"], ["float64", "Float64Array"], ["bool", "boolean[]"], ["string", "string[]"],
]);

const lastOf = (name) => name.split("/").at(-1);

function doc(comment, indent = "") {
  if (!comment) return "";
  const lines = comment.replaceAll("*/", "* /").split("\n");
  if (lines.length === 1) return `${indent}/** ${lines[0]} */\n`;
  return `${indent}/**\n${lines.map((line) => `${indent} * ${line}\n`).join("")}${indent} */\n`;
}

/** A field whose comment says "see Variable_Constants" has those values. */
function typeOf({ type, isComplex, isArray }, comment, where) {
  if (isComplex) return isArray ? `${lastOf(type)}[]` : lastOf(type);
  const known = (isArray ? ARRAYS : VALUES).get(type);
  if (!known) throw new Error(`${where}: the page cannot read the type ${type}${isArray ? "[]" : ""}`);
  return (!isArray && /\bsee (\w+_Constants)\b/.exec(comment)?.[1]) || known;
}

function interfaceOf(name, fields, comments) {
  const lines = fields.map((field) => {
    const path = `${name}.${field.name}`;
    const comment = comments.get(path) ?? "";
    return `${doc(comment, "  ")}  ${field.name}: ${typeOf(field, comment, path)};\n`;
  });
  return `${doc(comments.get(name))}export interface ${name} {\n${lines.join("")}}\n`;
}

function constantsOf(name, constants, comments) {
  const lines = constants.map((each) => `${doc(comments.get(`${name}.${each.name}`), "  ")}  ${each.name}: ${each.valueText},\n`);
  const values = `${doc(comments.get(name))}export const ${name} = {\n${lines.join("")}} as const;\n`;
  return `${values}export type ${name} = (typeof ${name})[keyof typeof ${name}];\n`;
}

/** The declarations of a file. `schema`: its text with what it includes; `text`: the file alone. */
function declarations(file, schema, text) {
  const comments = commentsOf(text);
  return parseRos2idl(schema).filter(({ name }) => name.startsWith(`${file}/`)).map(({ name: full, definitions }) => {
    const name = lastOf(full);
    const isConstants = definitions.length > 0 && definitions.every(({ isConstant }) => isConstant);
    const code = isConstants ? constantsOf(name, definitions, comments) : interfaceOf(name, definitions, comments);
    return { name, full, isConstants, code };
  });
}

function refuseTwins(all) {
  for (const [i, { name, full }] of all.entries()) {
    const twin = all.findIndex((each) => each.name === name);
    if (twin < i) throw new Error(`${full} and ${all[twin].full} have one name in TypeScript: rename one of them`);
  }
}

/** A module with the types of all `files`, each {name, schema, text}. Errors: what the page cannot read, with its file. */
export function moduleOf(files) {
  const all = files.flatMap(({ name, schema, text }) => {
    try {
      return declarations(name, schema, text);
    } catch (error) {
      throw new Error(`core/wire/idl/${name}.idl: error: ${error.message}`);
    }
  });
  refuseTwins(all);
  const types = all.filter(({ isConstants }) => !isConstants);
  const index = types.map(({ name, full }) => `  "${full}": ${name};\n`).join("");
  const messages = `/** What is decoded, by the name that a channel gives its schema. */\nexport interface Messages {\n${index}}\n`;
  return [...all.map(({ code }) => code), messages].join("\n");
}
