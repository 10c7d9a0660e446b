// SPDX-License-Identifier: BSD-3-Clause
// Where a machine's states and arrows are drawn: states in the cells of a grid that fills the room
// there is, placed so that arrows are short.

import type { MachineTransition } from "../feed/messages";
import type { Machine } from "../feed/parts";
import { type Box, arrowPath } from "./machine_arrow";
import { placed } from "./machine_places";

export interface LaidState extends Box {
  readonly name: string;
  readonly lines: readonly string[];
}

/** All transitions from one state to another, as one arrow. */
export interface LaidArrow {
  readonly from: string;
  readonly to: string;
  readonly path: string;
  readonly transitions: readonly MachineTransition[];
}

export interface MachineLayout {
  readonly width: number;
  readonly height: number;
  readonly states: readonly LaidState[];
  readonly arrows: readonly LaidArrow[];
}

export interface Room {
  readonly width: number;
  readonly height: number;
}

const CHARACTER_PX = 6.7;
const LINE_PX = 14;
const LONGEST_LINE = 11;
/** Between states: room for arrows and their heads. */
const GAP_PX = { x: 22, y: 20 };
/** Where there is more room than that, states stand no farther apart. */
const WIDEST_GAP_PX = { x: 70, y: 46 };

/** A long name on two lines, broken at the underscore nearest its middle. */
export function labelLines(name: string): string[] {
  const middle = name.length / 2;
  const breaks = [...name.matchAll(/_/g)].map((match) => match.index);
  if (name.length <= LONGEST_LINE || breaks.length === 0) return [name];
  const at = breaks.reduce((best, place) => (Math.abs(place - middle) < Math.abs(best - middle) ? place : best));
  return [name.slice(0, at + 1), name.slice(at + 1)];
}

function sizeOf(lines: readonly string[]): Room {
  const width = Math.max(...lines.map((line) => line.length)) * CHARACTER_PX + 14;
  return { width: Math.max(width, 52), height: lines.length * LINE_PX + 7 };
}

function arrowsOf(machine: Machine): Map<string, MachineTransition[]> {
  const known = new Set(machine.states.map(({ name }) => name));
  const arrows = new Map<string, MachineTransition[]>();
  for (const transition of machine.transitions) {
    if (!known.has(transition.from_state) || !known.has(transition.to_state)) continue;
    const key = JSON.stringify([transition.from_state, transition.to_state]);
    arrows.set(key, [...(arrows.get(key) ?? []), transition]);
  }
  return arrows;
}

/** A grid of the room's own shape, of no more columns than it takes at full size. */
function columnsFor(count: number, cell: Room, room: Room): number {
  const [across, down] = [Math.max(room.width / cell.width, 1), Math.max(room.height / cell.height, 1)];
  const ofItsShape = Math.ceil(Math.sqrt((count * across) / down) - 0.25);
  const needed = Math.ceil(count / Math.floor(down));
  return Math.min(Math.max(ofItsShape, needed, 1), Math.floor(across), count);
}

/** Drawn at scale 1 in `room` (pixels), or larger than it where the states need more. */
export function layOut(machine: Machine, room: Room): MachineLayout {
  const names = machine.states.map(({ name }) => name);
  if (names.length === 0) return { width: 0, height: 0, states: [], arrows: [] };
  const arrows = arrowsOf(machine);
  const ways = [...arrows.keys()].map((key) => JSON.parse(key) as [string, string]);
  const labels = new Map(names.map((name) => [name, labelLines(name)]));
  const sizes = names.map((name) => sizeOf(labels.get(name)!));
  const widest = { width: Math.max(...sizes.map(({ width }) => width)), height: Math.max(...sizes.map(({ height }) => height)) };
  const cell = { width: widest.width + GAP_PX.x, height: widest.height + GAP_PX.y };
  const columns = columnsFor(names.length, cell, room);
  const rows = Math.ceil(names.length / columns);
  const pitch = {
    x: Math.min(Math.max(room.width / columns, cell.width), widest.width + WIDEST_GAP_PX.x),
    y: Math.min(Math.max(room.height / rows, cell.height), widest.height + WIDEST_GAP_PX.y),
  };
  const places = placed(names, machine.start_state, ways, columns);
  const states = names.map((name, i): LaidState => {
    const { column, row } = places.get(name)!;
    const size = sizes[i]!;
    const [x, y] = [(column + 0.5) * pitch.x - size.width / 2, (row + 0.5) * pitch.y - size.height / 2];
    return { name, lines: labels.get(name)!, x, y, ...size };
  });
  const boxes = new Map(states.map((state) => [state.name, state]));
  const drawn = ways.map(([from, to]) => ({
    from,
    to,
    path: arrowPath(boxes.get(from)!, boxes.get(to)!, states),
    transitions: arrows.get(JSON.stringify([from, to]))!,
  }));
  return { width: columns * pitch.x, height: rows * pitch.y, states, arrows: drawn };
}
