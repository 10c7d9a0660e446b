// SPDX-License-Identifier: BSD-3-Clause
// Draws the rooms of tests/architecture/rooms.mjs as docs/ARCHITECTURE.md shows them:
//   node scripts/draw_rooms.mjs [--write]
// A room stands above all rooms that it may include; the lowest floor includes none.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { rooms } from '../tests/architecture/rooms.mjs';

const page = new URL('../docs/ARCHITECTURE.md', import.meta.url);
const BEGIN = '<!-- made by scripts/draw_rooms.mjs -->\n```text\n';
const END = '```\n<!-- end -->';
const WIDTH = 96;

/** The floor of each room of `inside`, from 0 up. What may include everything stands on top. */
function floors(inside) {
  const known = new Map();
  const floor = (room) => {
    if (!known.has(room)) known.set(room, 1 + Math.max(-1, ...inside[room].filter((below) => below !== '.').map(floor)));
    return known.get(room);
  };
  const ordinary = Object.keys(inside).filter((room) => inside[room] !== '*');
  const top = 1 + Math.max(...ordinary.map(floor));
  return new Map(Object.keys(inside).map((room) => [room, known.get(room) ?? top]));
}

function wrapped(words, width) {
  const lines = [''];
  for (const word of words) {
    const longer = lines.at(-1) ? `${lines.at(-1)}   ${word}` : word;
    if (longer.length <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

function drawn(top, inside) {
  const byFloor = new Map();
  for (const [room, floor] of floors(inside)) {
    if (room !== '.') byFloor.set(floor, [...(byFloor.get(floor) ?? []), room]);
  }
  const inner = WIDTH - 4;
  const lines = [...byFloor.keys()].sort((a, b) => b - a)
    .flatMap((floor) => wrapped(byFloor.get(floor), inner).map((line) => `│ ${line.padEnd(inner)} │`));
  const rule = '─'.repeat(WIDTH - top.length - 5);
  return [`┌─ ${top} ${rule}┐`, ...lines, `└${'─'.repeat(WIDTH - 2)}┘`].join('\n');
}

/** The whole picture: the folders that include others above those that they include. */
export function picture() {
  return ['web', 'monitor', 'sim', 'robot', 'bhdl', 'core'].map((top) => drawn(top, rooms[top])).join('\n') + '\n';
}

/** The page's text with the picture in its place. */
export function withPicture(text) {
  const from = text.indexOf(BEGIN), to = text.indexOf(END);
  if (from < 0 || to < from) throw new Error('docs/ARCHITECTURE.md lacks the lines between which the picture stands');
  return text.slice(0, from + BEGIN.length) + picture() + text.slice(to);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  if (process.argv.includes('--write')) writeFileSync(page, withPicture(readFileSync(page, 'utf8')));
  else process.stdout.write(picture());
}
