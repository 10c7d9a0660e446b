// SPDX-License-Identifier: BSD-3-Clause
// The alarms that somebody has yet to see, and those that last.

import { type AlarmGroup, groupedAlarms, wordsByRobot } from "./alarm_groups";
import { intake } from "./intake";
import { live } from "./live.svelte";
import { acknowledged, type Alarm, alarms, boardAt, type PostedAlarm, withAlarms } from "./alarms";

class AlarmBoard {
  posted = $state.raw<readonly PostedAlarm[]>([]);
  readonly unseen: number = $derived(this.posted.filter(({ seen }) => !seen).length);

  readonly groups: readonly AlarmGroup[] = $derived(groupedAlarms(this.posted));
  /** What is wrong, in words, of each robot that has an alarm at the instant that is shown. */
  readonly wordsByRobot: ReadonlyMap<string, readonly string[]> = $derived(wordsByRobot(live.isPast ? alarms(live.team, live.known_ms) : this.#lasting));

  constructor() {
    live.onRewind((to_ms) => (this.posted = boardAt(this.posted, to_ms)));
  }

  get #lasting(): Alarm[] {
    return this.posted.filter(({ over_ms }) => over_ms === undefined).map(({ alarm }) => alarm);
  }

  /** Called as time goes on: what is wrong depends on it, too. */
  refresh(): void {
    this.posted = withAlarms(this.posted, [...alarms(live.present, live.known_present_ms), ...intake.alarms(live.present_ms)], live.present_ms);
  }

  acknowledge(keys?: readonly string[]): void {
    this.posted = acknowledged(this.posted, keys);
  }
}

export const alarmBoard = new AlarmBoard();
