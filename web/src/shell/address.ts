// SPDX-License-Identifier: BSD-3-Clause
// The part of the page's address that tells what is looked at. It is made of what is named here alone, so that
// nothing else that stood in an address, such as a token, comes into it.

import { dateTime, dayTime } from "../lib/format";

/** A recording, and how far from its start. */
export interface Played {
  readonly name: string;
  readonly at_s: number;
}

/** One plotted number: its robot, variable and quantity. */
export type PlotName = readonly [robot: string, variable: string, quantity: string];

export interface View {
  readonly robot?: string | undefined;
  /** Undefined: the present. */
  readonly at_ms?: number | undefined;
  /** The recording that is shown, and where it is; undefined: the live team is. */
  readonly recording?: Played | undefined;
  readonly plots: readonly PlotName[];
  /** The arrangement, as a shared link has it. */
  readonly layout?: string | undefined;
}

const SECONDS = /^\d+(\.\d+)?$/;
const INSTANT = /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z$/;

function plotsOf(text: string | null, faults: string[]): PlotName[] {
  if (!text) return [];
  return text.split(",").flatMap((each): PlotName[] => {
    const [robot, variable, quantity, ...more] = each.split(":");
    if (robot && variable && quantity && more.length === 0) return [[robot, variable, quantity]];
    faults.push(`The address asks for the plot “${each}”, which is no ROBOT:VARIABLE:QUANTITY.`);
    return [];
  });
}

function playedIn(given: URLSearchParams, faults: string[]): Played | undefined {
  const [name, at] = [given.get("recording"), given.get("at")];
  if (!name) return undefined;
  const isRead = at === null || SECONDS.test(at);
  if (!isRead) faults.push(`The address asks for “${at}” of a recording, which is no number of seconds from its start.`);
  return { name, at_s: isRead ? Number(at ?? 0) : 0 };
}

function instantIn(given: URLSearchParams, faults: string[]): number | undefined {
  const at = given.get("at");
  const at_ms = at !== null && INSTANT.test(at) ? Date.parse(at) : Number.NaN;
  if (!Number.isNaN(at_ms)) return at_ms;
  if (at !== null) faults.push(`The address asks for the instant “${at}”, which is no time such as 2024-01-01T12:00:00Z.`);
  return undefined;
}

/** Reads an address's query. What makes no sense in it is left out, with a sentence each. */
export function viewOf(search: string): { readonly view: View; readonly faults: readonly string[] } {
  const given = new URLSearchParams(search);
  const faults: string[] = [];
  const recording = playedIn(given, faults);
  const view: View = {
    robot: given.get("robot") || undefined,
    ...(recording ? { recording } : { at_ms: instantIn(given, faults) }),
    plots: plotsOf(given.get("plots"), faults),
    layout: given.get("layout") || undefined,
  };
  return { view, faults };
}

/** The query that viewOf reads; empty for a page as it opens. */
export function searchOf({ robot, at_ms, recording, plots, layout }: View): string {
  const query = new URLSearchParams();
  if (recording) query.set("recording", recording.name);
  const at_s = Number(recording?.at_s.toFixed(3) ?? 0);
  if (at_s > 0) query.set("at", String(at_s));
  if (robot) query.set("robot", robot);
  if (at_ms !== undefined) query.set("at", new Date(at_ms).toISOString());
  if (plots.length > 0) query.set("plots", plots.map((plot) => plot.join(":")).join(","));
  if (layout) query.set("layout", layout);
  const text = query.toString().replace(/%3A/g, ":").replace(/%2C/g, ",").replace(/%28/g, "(").replace(/%29/g, ")").replace(/%27/g, "'");
  return text ? `?${text}` : "";
}

/** Why a page cannot show the instant that its address asks for; undefined where it can. */
export function instantFault(at_ms: number, heard: { readonly earliest_ms: number; readonly present_ms: number }): string | undefined {
  const asked = `The address asks for ${dateTime(at_ms, heard.present_ms)}`;
  if (at_ms > heard.present_ms) return `${asked}, which is yet to come. The page shows the present.`;
  if (at_ms >= heard.earliest_ms) return undefined;
  return `${asked}. This page was opened later and has heard nothing from before ${dayTime(heard.earliest_ms)}. It shows the present.`;
}
