// SPDX-License-Identifier: BSD-3-Clause
// Numbers and times as an operator reads them: with units, and no more digits than they are good for.

const MINUS = "−";

export function signed(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits);
  return value < 0 && Number(text) !== 0 ? MINUS + text : text;
}

export function metres(value_m: number): string {
  return inUnit(value_m, "m");
}

/** A certainty, 0 to 1: "0.92" */
export function sureness(certainty: number): string {
  return certainty.toFixed(2);
}

/** Digits after the point, by unit. */
const DIGITS: Readonly<Record<string, number>> = { "°": 0, "°/s": 0 };

/** A number of that unit; without a unit, a bare one: "−0.40 m", "90°", "1.00" */
export function inUnit(value: number, unit: string): string {
  const space = unit === "" || unit.startsWith("°") ? "" : " ";
  return `${signed(value, DIGITS[unit] ?? 2)}${space}${unit}`;
}

/** Whole degrees, −180 to 180. */
export function degrees(angle_rad: number): string {
  const turned = Math.atan2(Math.sin(angle_rad), Math.cos(angle_rad));
  return inUnit((turned * 180) / Math.PI, "°");
}

/** "07:42" */
export function clock(duration_s: number): string {
  const whole = Math.max(Math.floor(duration_s), 0);
  const part = (value: number) => String(value).padStart(2, "0");
  return `${part(Math.floor(whole / 60))}:${part(whole % 60)}`;
}

/** How long something has lasted: "0.4 s", "12 s", "3 min", "2 h". */
export function lasting(duration_s: number): string {
  const whole = Math.max(duration_s, 0);
  if (whole < 9.95) return `${whole.toFixed(1)} s`;
  if (whole < 119.5) return `${Math.round(whole)} s`;
  return whole < 7200 ? `${Math.round(whole / 60)} min` : `${Math.round(whole / 3600)} h`;
}

/** Made once: a date that is put into words by itself makes another each time. */
const TIME_OF_DAY = new Intl.DateTimeFormat("en-GB", { hour: "2-digit", minute: "2-digit", second: "2-digit" });

/** The time of day: "12:03:11". */
export function dayTime(at_ms: number): string {
  return TIME_OF_DAY.format(at_ms);
}

const dateOf = (at_ms: number) => new Date(at_ms).toLocaleDateString("sv-SE");

/** "2024-11-28 12:03:11" */
export function dateAndTime(at_ms: number): string {
  return `${dateOf(at_ms)} ${dayTime(at_ms)}`;
}

/** The time of day, with the date where it is another day than that of `now_ms`: "2024-11-28 12:03:11". */
export function dateTime(at_ms: number, now_ms: number): string {
  return dateOf(at_ms) === dateOf(now_ms) ? dayTime(at_ms) : dateAndTime(at_ms);
}

/** "00:12.3" */
export function preciseClock(duration_s: number): string {
  const tenths = Math.max(Math.floor(duration_s * 10 + 1e-6), 0);
  return `${clock(Math.floor(tenths / 10))}.${tenths % 10}`;
}

const UNITS = ["B", "kB", "MB", "GB", "TB"];

/** "12 MB" */
export function size(bytes: number): string {
  const power = Math.min(Math.max(Math.floor(Math.log10(Math.max(bytes, 1)) / 3), 0), UNITS.length - 1);
  const value = bytes / 1000 ** power;
  return `${value.toFixed(value < 10 && power > 0 ? 1 : 0)} ${UNITS[power]}`;
}

/** A delay: milliseconds below a second, then seconds and more: "85 ms", "1.4 s", "21 s". */
export function delay(duration_ms: number): string {
  return duration_ms < 999.5 ? `${duration_ms.toFixed(0)} ms` : lasting(duration_ms / 1000);
}

const RECENT_S = 60;

/** Relative when recent, clock when old. */
export function when(at_ms: number, now_ms: number): string {
  const ago_s = (now_ms - at_ms) / 1000;
  if (ago_s < 1) return "now";
  if (ago_s < RECENT_S) return `${Math.round(ago_s)} s ago`;
  return dayTime(at_ms);
}

/** A hash as people compare it. */
export function shortHash(hash: string): string {
  return hash.slice(0, 4);
}

/** A long name with its middle left out. */
export function shortened(name: string, longest: number): string {
  if (name.length <= longest) return name;
  const ends = longest - 1;
  return `${name.slice(0, Math.ceil(ends / 2))}…${name.slice(name.length - Math.floor(ends / 2))}`;
}

/** A name with as much of its middle left out as it takes to fit; `width` measures a text in pixels. */
export function fitted(name: string, room_px: number, width: (text: string) => number): string {
  for (let longest = name.length; longest > 2; longest -= 1) {
    const text = shortened(name, longest);
    if (width(text) <= room_px) return text;
  }
  return shortened(name, 2);
}

export function plural(count: number, one: string, many = `${one}s`): string {
  return `${signed(count, 0)} ${Math.abs(count) === 1 ? one : many}`;
}

/** "io", "io and callisto", "io, ganymede and callisto" */
export function listed(names: readonly string[]): string {
  return names.length < 2 ? names.join("") : `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`;
}
