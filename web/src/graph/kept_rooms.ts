// SPDX-License-Identifier: BSD-3-Clause
// The room that each machine was laid out for. A machine keeps its places when its panel changes size:
// whoever knows where a state stands finds it there again.

import type { Machine } from "../feed/parts";
import type { Room } from "./machine_layout";

/** An editor makes another machine with each state that is typed. */
const KEPT = 50;

function keyOf({ start_state, states, transitions }: Machine): string {
  return JSON.stringify([start_state, states.map(({ name }) => name), transitions.map(({ from_state, to_state }) => [from_state, to_state])]);
}

export class KeptRooms {
  #rooms = new Map<string, Room>();

  /** Returns the room that the machine is laid out for: that in which it was shown first. */
  roomFor(machine: Machine, room: Room): Room {
    const kept = this.#rooms.get(keyOf(machine));
    return kept ?? this.layOutFor(machine, room);
  }

  /** Lays the machine out anew for a room. A panel that is not shown yet has none, and is not kept. */
  layOutFor(machine: Machine, room: Room): Room {
    const kept = { width: room.width, height: room.height };
    if (kept.width === 0 || kept.height === 0) return kept;
    this.#rooms.set(keyOf(machine), kept);
    if (this.#rooms.size > KEPT) this.#rooms.delete(this.#rooms.keys().next().value!);
    return kept;
  }
}

export const keptRooms = new KeptRooms();

/** How large a layout is drawn in a room: as much larger than its own room as that is, and never below `least`. */
export function fitOf(laid: Room, own: Room, room: Room, least: number): number {
  const grown = Math.max(Math.min(room.width / own.width, room.height / own.height), 1);
  return Math.max(Math.min(room.width / laid.width, room.height / laid.height, grown), least);
}
