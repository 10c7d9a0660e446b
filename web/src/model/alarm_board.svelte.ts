// SPDX-License-Identifier: BSD-3-Clause
// The alarms that somebody has yet to see, and those that last.

import { type AlarmGroup, groupedAlarms, wordsByRobot } from "./alarm_groups";
import { live } from "./live.svelte";
import { acknowledged, alarms, type PostedAlarm, withAlarms } from "./alarms";

class AlarmBoard {
  posted = $state.raw<readonly PostedAlarm[]>([]);
  readonly unseen: number = $derived(this.posted.filter(({ seen }) => !seen).length);

  readonly groups: readonly AlarmGroup[] = $derived(groupedAlarms(this.posted));
  /** What lasts, in words, of each robot that has an alarm. */
  readonly wordsByRobot: ReadonlyMap<string, readonly string[]> = $derived(wordsByRobot(this.posted));

  /** Called as time goes on: what is wrong depends on it, too. */
  refresh(): void {
    this.posted = withAlarms(this.posted, alarms(live.present, live.known_present_ms), live.present_ms);
  }

  acknowledge(keys?: readonly string[]): void {
    this.posted = acknowledged(this.posted, keys);
  }
}

export const alarmBoard = new AlarmBoard();
