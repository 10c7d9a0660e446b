// SPDX-License-Identifier: BSD-3-Clause
// Which of its changes of state stopped a robot, as far as the page has heard.

import type { Breaks, Transition } from "../feed/messages";
import { seconds } from "../feed/parts";
import { stopperWords, stopReason } from "./breaks";
import { withStopEvent } from "./events";
import type { Robot, Stop } from "./model";

/** As many as transitions are kept. */
const KEPT = 100;
/** The robot's clock may be set between a change and the message of what stopped it there. */
const CLOCK_SLACK_S = 0.5;

type Stops = ReadonlyMap<bigint, Stop>;

function withStop(stops: Stops, breaks: Breaks): Stops {
  const { stopped, stopped_at: number, stamp } = breaks;
  if (!stopped || number === 0n) return stops;
  const kept = [...stops].filter(([other]) => other !== number).slice(1 - KEPT);
  return new Map(kept).set(number, { told_s: seconds(stamp), by: stopperWords(breaks) });
}

/** Whether it was made to stand since it told of itself before. When a page hears it first, it stood already. */
function isNewStop(before: Breaks | undefined, breaks: Breaks): boolean {
  if (!before || !breaks.stopped) return false;
  return !before.stopped || before.stopped_at !== breaks.stopped_at || stopperWords(before) !== stopperWords(breaks);
}

export function withBreaks(robot: Robot, value: Breaks, received_ms: number): Robot {
  const next = { ...robot, breaks: { value, received_ms }, stops: withStop(robot.stops ?? new Map(), value) };
  if (!isNewStop(robot.breaks?.value, value)) return next;
  return { ...next, events: withStopEvent(robot.events, stopReason(next)!, received_ms) };
}

/** Without what stopped it after its change of that number. */
export function withoutLater({ stops }: Robot, count: bigint): Pick<Robot, "stops"> {
  return stops ? { stops: new Map([...stops].filter(([number]) => number <= count)) } : {};
}

/** What stopped the robot at a change. One of that number from before a restart was told before the change. */
export function stopAt({ stops }: Pick<Robot, "stops">, { number, stamp }: Transition): string | undefined {
  const stop = stops?.get(number);
  return stop && stop.told_s >= seconds(stamp) - CLOCK_SLACK_S ? stop.by : undefined;
}
