// SPDX-License-Identifier: BSD-3-Clause
// What the monitor did not take of what comes over DDS, and what it lost of robots' events, as alarms. It counts since it was started, and says nothing of when.

import type { ChannelIntake, RefusedMessages, Status } from "../feed/api";
import { plural } from "../lib/format";
import type { Alarm } from "./alarms";

/** The part of what the monitor tells that is of it. */
export type IntakeStatus = Pick<Status, "channels" | "refused_messages" | "topics_not_read">;

/** It goes on where more came so lately. The monitor is asked some times within this. */
const GOES_ON_MS = 30_000;
const TOPICS_NOT_READ = "topics";

interface Count {
  readonly count: number;
  /** When it was another one last, or was first told. */
  readonly changed_ms: number;
}

/** The name that stands first in a topic: the robot's, of those of robots. */
const senderOf = (topic: string): string => /^rt\/([^/]+)/.exec(topic)?.[1] ?? topic;

function alarmOf(key: string, { topic, reason, messages }: RefusedMessages): Alarm {
  const isNamed = topic.startsWith("rt/");
  const name = topic.slice("rt".length);
  const place = isNamed ? ` on ${name}` : "";
  return {
    key: `refused ${key}`,
    kind: "refused",
    robot: senderOf(topic),
    words: `${plural(messages, "message")}${place} ${messages === 1 ? "was" : "were"} not taken: ${reason}.`,
    timed: true,
    advice: isNamed ? `Find out who writes the topic (galilean info ${name}), and stop or update it.` : "Find out who writes them (galilean list), and stop it.",
  };
}

function alarmOfLosses({ topic, lost }: ChannelIntake): Alarm {
  const words = `${plural(lost, "message")} on ${topic.slice("rt".length)} ${lost === 1 ? "was" : "were"} lost: more happened in a gap than the robot keeps.`;
  return { key: `lost ${topic}`, kind: "lost", robot: senderOf(topic), words, timed: true, advice: "Look at its network. What it did then stands in a recording that was made beside it, if there is one." };
}

function alarmOfTopics(topics: number): Alarm {
  const words = `${plural(topics, "topic")} ${topics === 1 ? "is" : "are"} not read, because there are too many.`;
  return { key: `refused ${TOPICS_NOT_READ}`, kind: "refused", robot: "(others)", words, timed: true, advice: "Find out who makes them (galilean list), and stop it." };
}

const lossesIn = ({ channels = [] }: IntakeStatus): ChannelIntake[] => channels.filter(({ lost }) => lost > 0);

export class Intake {
  #status: IntakeStatus = { refused_messages: [], topics_not_read: 0 };
  #counts: ReadonlyMap<string, Count> = new Map();

  /** Takes in what the monitor said at `now_ms`. A monitor that was started anew counts anew. */
  told(status: IntakeStatus, now_ms: number): void {
    const counts = new Map(status.refused_messages.map((refused) => [Intake.#keyOf(refused), refused.messages]));
    for (const channel of lossesIn(status)) counts.set(`lost ${channel.topic}`, channel.lost);
    if (status.topics_not_read > 0) counts.set(TOPICS_NOT_READ, status.topics_not_read);
    this.#counts = new Map([...counts].map(([key, count]) => [key, this.#counted(key, count, now_ms)]));
    this.#status = status;
  }

  /** What goes on: more was not taken lately. */
  alarms(now_ms: number): Alarm[] {
    const goesOn = (key: string): boolean => now_ms - (this.#counts.get(key)?.changed_ms ?? -Infinity) < GOES_ON_MS;
    const refused = this.#status.refused_messages.filter((each) => goesOn(Intake.#keyOf(each))).map((each) => alarmOf(Intake.#keyOf(each), each));
    const lost = lossesIn(this.#status).filter(({ topic }) => goesOn(`lost ${topic}`)).map(alarmOfLosses);
    const topics = goesOn(TOPICS_NOT_READ) ? [alarmOfTopics(this.#status.topics_not_read)] : [];
    return [...refused, ...lost, ...topics];
  }

  static #keyOf({ topic, reason }: RefusedMessages): string {
    return `${topic} ${reason}`;
  }

  #counted(key: string, count: number, now_ms: number): Count {
    const before = this.#counts.get(key);
    return before?.count === count ? before : { count, changed_ms: now_ms };
  }
}

export const intake = new Intake();
