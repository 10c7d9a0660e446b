import type { Machine, MachineState, MachineTransition } from "../feed/messages";

export interface MachineDiff {
  readonly added: readonly string[];
  readonly removed: readonly string[];
  /** States that both have, with other schemas or other ways out. */
  readonly changed: readonly string[];
}

function schemas(state: MachineState): string {
  return JSON.stringify([state.perceptual_schemas, state.motor_schemas]);
}

function waysOut(machine: Machine, state: string): string {
  const said = ({ to_state, bits_variable, bit_index, bit_value, bit_update, reset_variables }: MachineTransition) =>
    [to_state, bits_variable, bit_index, Number(bit_value), bit_update, ...reset_variables].join(" ");
  return JSON.stringify(machine.transitions.filter((transition) => transition.from_state === state).map(said));
}

/** What a new program changes in the machine that runs, told by states; where text stands does not matter. */
export function machineDiff(running: Machine, next: Machine): MachineDiff {
  const before = new Map(running.states.map((state) => [state.name, state]));
  const after = new Map(next.states.map((state) => [state.name, state]));
  const differs = (name: string) =>
    schemas(before.get(name)!) !== schemas(after.get(name)!) || waysOut(running, name) !== waysOut(next, name);
  return {
    added: [...after.keys()].filter((name) => !before.has(name)),
    removed: [...before.keys()].filter((name) => !after.has(name)),
    changed: [...after.keys()].filter((name) => before.has(name) && differs(name)),
  };
}

/** The diff in words, for the one who is about to push. */
export function diffInWords({ added, removed, changed }: MachineDiff): string[] {
  const say = (verb: string, names: readonly string[]) => (names.length ? [`${verb} ${names.join(", ")}`] : []);
  const lines = [...say("adds", added), ...say("removes", removed), ...say("changes", changed)];
  return lines.length ? lines : ["leaves states and transitions as they are"];
}
