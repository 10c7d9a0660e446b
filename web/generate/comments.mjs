// SPDX-License-Identifier: BSD-3-Clause
// What the comments of an IDL file say of which type, field or constant. The parser of the types drops them.

const BLOCK = /^(?:@final struct|module) (\w+) \{/;
const GUARD = /^#(ifndef|define)/;
const DECLARED = /(\w+)(?:\[\d+\])?(?: = \w+)?\s*;/g;

/** A line's code and its comment, without the signs between them. */
function divided(line) {
  const at = line.indexOf("//");
  return at < 0 ? [line.trim(), ""] : [line.slice(0, at).trim(), line.slice(at + 2).trim()];
}

/**
 * The comments of an IDL text, lines above a declaration and what stands behind it, by "RobotState" or "RobotState.tick".
 * Those of the file as a whole, above its first include or module, stand by "".
 */
export function commentsOf(text) {
  const comments = new Map();
  const note = (name, lines) => lines.length > 0 && comments.set(name, [...(comments.get(name) ?? []), ...lines]);
  let above = [];
  let block;
  for (const line of text.split("\n")) {
    const [code, behind] = divided(line);
    if (code === "" && behind) {
      above.push(behind);
      continue;
    }
    const lines = behind ? [...above, behind] : above;
    const name = code.endsWith("module msg {") ? undefined : BLOCK.exec(code)?.[1];
    if (name) note((block = name), lines);
    else if (block) for (const [, member] of code.matchAll(DECLARED)) note(`${block}.${member}`, lines);
    else if (!GUARD.test(code)) note("", lines);
    if (code.endsWith("};")) block = undefined;
    above = [];
  }
  return new Map([...comments].map(([name, lines]) => [name, lines.join("\n")]));
}
