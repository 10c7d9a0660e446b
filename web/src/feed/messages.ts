// The messages of core/wire/idl as they come out of the decoder: SI units, frames as the IDL says.

export interface Time {
  sec: number;
  nsec: number;
}

export interface RobotState {
  stamp: Time;
  robot: string;
  program_name: string;
  program_hash: string;
  state: string;
  state_since: Time;
  tick: bigint;
  transitions: bigint;
  tick_period_s: number;
  tick_time_us: number;
  tick_time_max_us: number;
  overruns: number;
  held: boolean;
  in_probation: boolean;
  out_of_service: boolean;
  x_m: number;
  y_m: number;
  heading_rad: number;
  problems: string[];
}

/** A condition as the robot's sequencer found it, before one fired. */
export interface TestedCondition {
  to_state: string;
  file: string;
  line: number;
  bits_variable: string;
  bit_index: number;
  /** What it waits for. */
  bit_value: boolean;
  valid: boolean;
  holds: boolean;
}

export interface Transition {
  stamp: Time;
  robot: string;
  number: bigint;
  tick: bigint;
  from_state: string;
  to_state: string;
  cause: string;
  program_hash: string;
  file: string;
  line: number;
  bits_variable: string;
  bit_index: number;
  bit_value: boolean;
  reset_variables: string[];
  tested: TestedCondition[];
}

export const VariableType = { shaft: 1, image: 2, locate: 3, bits: 4, force: 5 } as const;

export interface Variable {
  name: string;
  type: number;
  object_class: string;
  valid: boolean;
  certainty: number;
  decay_per_s: number;
  updated: Time;
  values: Float64Array | number[];
}

export interface Variables {
  stamp: Time;
  robot: string;
  tick: bigint;
  items: Variable[];
}

export interface SchemaForce {
  schema: string;
  variable: string;
  x: number;
  y: number;
  gain: number;
  active: boolean;
}

export interface Forces {
  stamp: Time;
  robot: string;
  tick: bigint;
  items: SchemaForce[];
}

export interface Covariance {
  variance_xx: number;
  variance_xy: number;
  variance_yy: number;
}

export interface Sighting extends Covariance {
  object_class: string;
  variable: string;
  x_m: number;
  y_m: number;
  range_m: number;
  azimuth_rad: number;
  left_px: number;
  top_px: number;
  right_px: number;
  bottom_px: number;
  area_px: number;
}

export interface Sightings {
  stamp: Time;
  robot: string;
  x_m: number;
  y_m: number;
  heading_rad: number;
  view_angle_rad: number;
  items: Sighting[];
}

export interface SourceFile {
  path: string;
  text: string;
}

export interface MachineState {
  name: string;
  file: string;
  line: number;
  perceptual_schemas: string[];
  motor_schemas: string[];
}

export interface MachineTransition {
  from_state: string;
  to_state: string;
  file: string;
  line: number;
  bits_variable: string;
  bit_index: number;
  bit_value: boolean | number;
  bit_update: string;
  reset_variables: string[];
}

export interface Machine {
  start_state: string;
  states: MachineState[];
  transitions: MachineTransition[];
}

export interface Program extends Machine {
  stamp: Time;
  robot: string;
  name: string;
  hash: string;
  files: SourceFile[];
}

export interface Catalog {
  robot: string;
  hash: string;
  json: string;
}

export interface ProgramPush {
  stamp: Time;
  id: string;
  author: string;
  targets: string[];
  replaces_hash: string;
  hash: string;
  files: SourceFile[];
}

export interface Diagnostic {
  file: string;
  line: number;
  column: number;
  severity: string;
  code: string;
  message: string;
  hint: string;
  /** Known only of what one types. */
  fix?: Fix;
}

/** What would put a problem right: another text between two places of its file, counted from 1. */
export interface Fix {
  title: string;
  from: { line: number; column: number };
  to: { line: number; column: number };
  text: string;
  /** The text of the whole file that it puts right; in any other its places are others. */
  of: string;
}

export const replyStatuses = ["no_answer", "received", "rejected", "running", "confirmed", "rolled_back"] as const;
export type ReplyStatus = (typeof replyStatuses)[number];

export interface ProgramReply {
  stamp: Time;
  id: string;
  robot: string;
  hash: string;
  running_hash: string;
  status: number;
  message: string;
  tick: bigint;
  swap_tick_us: number;
  kept_variables: string[];
  diagnostics: Diagnostic[];
}

export interface MapObject extends Covariance {
  id: number;
  object_class: string;
  x_m: number;
  y_m: number;
  certainty: number;
  decay_per_s: number;
  last_seen: Time;
  seen_by: string[];
  held_by: string;
}

export interface MapRobot extends Covariance {
  name: string;
  x_m: number;
  y_m: number;
  heading_rad: number;
  age_s: number;
  silent: boolean;
}

export interface PushStep {
  name: string;
  state: string;
  detail: string;
}

export interface PushProgress {
  stamp: Time;
  id: string;
  author: string;
  program: string;
  hash: string;
  targets: string[];
  state: string;
  steps: PushStep[];
}

export interface ObjectMap {
  stamp: Time;
  objects: MapObject[];
  robots: MapRobot[];
}

/** Something that the referee counted. */
export interface RefereeCall {
  elapsed_s: number;
  robot: string;
  what: string;
  points: number;
}

export interface Score {
  stamp: Time;
  scenario: string;
  phase: string;
  elapsed_s: number;
  remaining_s: number;
  pieces: number;
  deposited: number;
  collisions: number;
  points: number;
  points_per_piece: number;
  points_per_collision: number;
  robots: { robot: string; deposited: number; collisions: number }[];
  calls: RefereeCall[];
}

export interface OccupancyGrid {
  header: { stamp: Time; frame_id: string };
  info: {
    resolution: number;
    width: number;
    height: number;
    origin: { position: { x: number; y: number }; orientation: { z: number; w: number } };
  };
  data: Int8Array;
}

export interface CompressedImage {
  header: { stamp: Time; frame_id: string };
  format: string;
  data: Uint8Array;
}

export interface Log {
  stamp: Time;
  level: number;
  name: string;
  msg: string;
}

export function seconds(time: Time): number {
  return time.sec + time.nsec / 1e9;
}
