// SPDX-License-Identifier: BSD-3-Clause
// Playback control in Foxglove's protocol: one binary frame each way, which its library does not know. All numbers are
// little endian, times are ns since the epoch, speeds are recorded seconds a second.

/** To the monitor: opcode, u8 command, f32 speed, u8 whether it seeks, u64 where to, u32 length and text of the id. */
const REQUEST = 3;
/** From the monitor: opcode, u8 status, u64 now, f32 speed, u8 whether it sought, u32 length and text of the id. */
const STATE = 5;
/** Both heads are of this length. */
const HEAD_BYTES = 19;
const [PLAY, PAUSE] = [0, 1];
const STATUSES = ["playing", "paused", "buffering", "ended"] as const;

export type PlaybackStatus = (typeof STATUSES)[number];

export interface PlaybackRequest {
  readonly plays: boolean;
  readonly speed: number;
  /** Where to go on from; undefined: from where it is. */
  readonly seek_ns?: bigint | undefined;
  /** By which its answer is known. Requires: it is not empty. */
  readonly id: string;
}

export interface PlaybackState {
  readonly status: PlaybackStatus;
  readonly now_ns: bigint;
  readonly speed: number;
  /** What came before it is of another instant than what comes after it. */
  readonly sought: boolean;
  /** Of the request that it answers; empty: nobody asked. */
  readonly id: string;
}

export function requestFrame({ plays, speed, seek_ns, id }: PlaybackRequest): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(id);
  const frame = new Uint8Array(HEAD_BYTES + text.length);
  const view = new DataView(frame.buffer);
  view.setUint8(0, REQUEST);
  view.setUint8(1, plays ? PLAY : PAUSE);
  view.setFloat32(2, speed, true);
  view.setUint8(6, seek_ns === undefined ? 0 : 1);
  view.setBigUint64(7, seek_ns ?? 0n, true);
  view.setUint32(15, text.length, true);
  frame.set(text, HEAD_BYTES);
  return frame;
}

export const isStateFrame = (frame: ArrayBuffer): boolean => frame.byteLength > 0 && new DataView(frame).getUint8(0) === STATE;

/** What such a frame says; undefined: it makes no sense. */
export function stateOf(frame: ArrayBuffer): PlaybackState | undefined {
  if (frame.byteLength < HEAD_BYTES) return undefined;
  const view = new DataView(frame);
  const [status, length] = [STATUSES[view.getUint8(1)], view.getUint32(15, true)];
  if (!status || frame.byteLength < HEAD_BYTES + length) return undefined;
  return {
    status,
    now_ns: view.getBigUint64(2, true),
    speed: view.getFloat32(10, true),
    sought: view.getUint8(14) !== 0,
    id: new TextDecoder().decode(new Uint8Array(frame, HEAD_BYTES, length)),
  };
}
