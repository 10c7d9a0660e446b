// SPDX-License-Identifier: BSD-3-Clause
// A robot's letter, shape and colour, the same in every panel.

/** Okabe and Ito's colours less black and vermillion (which is for alarms); told apart by the colour-blind. */
const COLOURS = ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#0072b2", "#f0e442"] as const;

const DARK_COLOUR = "#0072b2";

/** Outlines in a box from −10 to 10, nose up. */
const SHAPES = [
  "M0,-11 L10,8.5 L-10,8.5 Z",
  "M-8,9 L-8,-4 L0,-10 L8,-4 L8,9 Z",
  "M0,-9.5 A9.5,9.5 0 1 1 -0.01,-9.5 Z",
  "M0,-10 L8.5,0 L0,10 L-8.5,0 Z",
  "M0,-10 L8,-5 L8,5 L0,10 L-8,5 L-8,-5 Z",
] as const;

const SHAPE_NAMES = ["triangle", "house", "circle", "diamond", "hexagon"] as const;

/** The paper's robots keep their places however late they come. */
const RESERVED = ["io", "ganymede", "callisto"];

export interface Identity {
  readonly index: number;
  readonly letter: string;
  readonly colour: string;
  /** Of the letter on that colour. */
  readonly ink: string;
  readonly shape: string;
  readonly shape_name: string;
}

function letterOf(name: string, taken: ReadonlySet<string>): string {
  const letters = [...name.toUpperCase()].filter((character) => /[A-Z0-9]/.test(character));
  const digits = /\d+$/.exec(name)?.[0] ?? "";
  const numbered = (letters[0] ?? "R") + digits;
  const candidates = digits ? [numbered] : letters;
  return candidates.find((candidate) => !taken.has(candidate)) ?? `${letters[0] ?? "R"}${taken.size + 1}`;
}

/** The identity of a robot that joins others. */
export function identityOf(name: string, others: readonly Identity[]): Identity {
  const taken = new Set(others.map((other) => other.index));
  let index = RESERVED.indexOf(name);
  if (index < 0) for (index = RESERVED.length; taken.has(index); ) index += 1;
  const colour = COLOURS[index % COLOURS.length]!;
  const shape = index % SHAPES.length;
  return {
    index,
    letter: letterOf(name, new Set(others.map((other) => other.letter))),
    colour,
    ink: colour === DARK_COLOUR ? "#fff" : "#111",
    shape: SHAPES[shape]!,
    shape_name: SHAPE_NAMES[shape]!,
  };
}
