// SPDX-License-Identifier: BSD-3-Clause
// What the panels see: the team now or at a chosen instant, the robot chosen, and the page's clock. Of a recording the
// present is the instant that is played, and time is the recording's.

import { flushSync } from "svelte";
import type { Connection } from "../feed/feed";
import { type Batch, CROWD, GLANCE_MS } from "../feed/inbox";
import { PageFeed } from "../feed/page_feed";
import type { DecodedPicture } from "../feed/picture_decoder";
import { robotTopicOf, tellsWhatHappens } from "../feed/topics";
import { plural } from "../lib/format";
import { Listeners } from "../lib/listeners";
import { haveSame } from "../lib/steady";
import { browserFrames, Redraw } from "../lib/redraw";
import { type Gap, withGap } from "./gaps";
import { History, type Instant } from "./history";
import { emptyTeam, type Robot, type Team } from "./model";
import { Playback } from "./playback.svelte";
import { rewound } from "./rewind";
import { silentIn, unwatched, watched, withSilencesUntil } from "./silence";
import { LOOK_MS, PageClock } from "./page_clock.svelte";
import { withInterrupted, withProgress, withPush, withReply } from "./pushes";
import { applyAll } from "./reduce";
import type { PushResult, Reply } from "../feed/api";
import { playedAt, recording } from "../feed/recording";
import { withToken } from "../feed/token";
import type { SourceFile, Transition } from "../feed/messages";

/** So long it takes until it is told how everything stood at the instant that a recording has gone to. */
const SETTLE_MS = 80;
const NO_CHANGES: readonly Transition[] = [];

class Live {
  connection = $state<Connection>("connecting");
  /** Since when nothing is heard from the monitor. */
  lost_ms = $state<number>();
  /** When nothing was heard from it: what happened then is not known. */
  gaps = $state.raw<readonly Gap[]>([]);
  trouble = $state<string>();
  /** The recording cannot be shown, and is asked for no more. */
  hasGivenUp = $state(false);
  chosen = $state<string>();
  /** The instant that the panels show; undefined: now. */
  instant_ms = $state<number>();
  #clock = new PageClock();
  #shown = $state.raw<Team>(emptyTeam);
  #glanced = $state.raw<Team>(emptyTeam);
  #glanced_ms = $state(0);
  #glanceWaits = false;
  /** When that was, by the browser's clock. */
  #glanceTold_ms = -Infinity;
  #silentNow = $state.raw<ReadonlySet<string>>(new Set());
  #team: Team = emptyTeam;
  /** Changes of state that are drawn ahead of all else that is known of their robot. */
  #ahead = $state.raw<Pick<Robot, "name" | "transitions">>();
  /** Something has happened that is no change of state, and is not drawn yet. */
  #hasOtherNews = false;
  #history = new History();
  #listeners = new Listeners<unknown>();
  #viewers = new Listeners<DecodedPicture>();
  #rewinders = new Set<(to_ms: number) => void>();
  /** The gaps at the instant that a recording has gone to, until that is drawn. */
  #gapsThen: readonly Gap[] | undefined;
  #frames = browserFrames();
  #redraw = new Redraw((isUrgent) => this.#draw(isUrgent), this.#frames);

  /** How the recording is played that the page shows; undefined: it shows the live team. */
  readonly playback: Playback | undefined = recording === undefined ? undefined : new Playback(recording, (request) => this.feed.play(request));

  feed: PageFeed = new PageFeed(
    withToken(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}${recording === undefined ? "/ws" : playedAt(recording)}`),
    {
      batch: (batch) => this.#take(batch),
      picture: (picture) => this.#viewers.tell(picture.topic, picture),
      connection: (connection) => this.#connected(connection),
      trouble: (sentence) => (this.trouble = sentence),
      begun: (range, now_ns) => this.#rewind((playback) => playback.begun(range, now_ns)),
      playback: (state, isBorder) => (isBorder ? this.#rewind((playback) => playback.told(state, true)) : this.playback?.told(state, false)),
    },
    recording === undefined ? undefined : { at_s: secondsIn(location.search) },
  );

  /** What is kept of the instant that is shown; undefined: the present is. */
  readonly #past: Instant | undefined = $derived(this.instant_ms === undefined ? undefined : this.#history.at(this.instant_ms));
  readonly team: Team = $derived(this.#past ? { ...this.#past.team, grid: this.#shown.grid } : this.#shown);
  /** The team where all of it is shown at once: of a crowd it is a little behind, which nobody sees. */
  get glance(): Team {
    return this.#past ? this.team : this.#glanced;
  }
  get presentGlance(): Team {
    return this.#glanced;
  }
  /** When that was. */
  get glanced_ms(): number {
    return this.#glanced_ms;
  }
  get now_ms(): number {
    return this.instant_ms ?? this.#clock.now_ms;
  }
  get present_ms(): number {
    return this.#clock.now_ms;
  }
  /** The same in coarse steps. */
  get step_ms(): number {
    return this.#clock.step_ms;
  }
  /**
   * The newest time of which the monitor told how things stood. Whether a robot is silent is judged by this and
   * not by the page's clock: a page that is behind, or without a monitor, knows nothing against a robot.
   */
  get known_present_ms(): number {
    return this.#clock.known_ms;
  }
  readonly known_ms: number = $derived(this.#past?.known_ms ?? this.instant_ms ?? this.known_present_ms);
  get behind_ms(): number {
    return this.#clock.behind_ms;
  }
  /** Whether what is shown as the present is older than an operator may take it for. */
  get isBehind(): boolean {
    return this.#clock.isBehind;
  }
  /** The monitor did not open the recording. */
  get isUnopened(): boolean {
    return this.connection === "lost" && this.playback !== undefined && !this.playback.range;
  }
  /** What time it is, drawn or not: of a recording as far as it was played. */
  get clock_ms(): number {
    return this.playback?.now_ms ?? Date.now();
  }
  get present(): Team {
    return this.#shown;
  }
  get isPast(): boolean {
    return this.instant_ms !== undefined;
  }
  /** Ends the name of a button that acts on the robots: while an instant of the past is shown, it says that it acts now. */
  get now(): string {
    return this.isPast ? " now" : "";
  }
  /** The names of those that were silent then, and of those that are. They change seldom, unlike the ages that tell it. */
  readonly silent: ReadonlySet<string> = $derived(this.#past ? silentIn(this.#past.team.robots.values(), this.known_ms) : this.#silentNow);
  get silentNow(): ReadonlySet<string> {
    return this.#silentNow;
  }
  readonly robots: Robot[] = $derived(inTheirOrder(this.team));
  readonly glancedRobots: Robot[] = $derived(inTheirOrder(this.glance));
  readonly robot: Robot | undefined = $derived(
    this.robots.find((robot) => robot.name === this.chosen) ?? this.robots[0],
  );
  readonly robotName: string | undefined = $derived(this.robot?.name);
  /** The changes of state of that robot. A new one is seen here before anything else shows it. */
  readonly changes: readonly Transition[] = $derived(
    (!this.#past && this.#ahead?.name === this.robotName ? this.#ahead : this.robot)?.transitions ?? NO_CHANGES,
  );
  /** The chosen robot as it is, whatever instant is shown: what acts on it must not go by the past. */
  readonly presentRobot: Robot | undefined = $derived(this.#shown.robots.get(this.robot?.name ?? ""));

  start(): void {
    this.feed.connect();
    setInterval(() => this.#isDue && this.#redraw.ask(), LOOK_MS);
  }

  /** The recording cannot be shown, for this reason, and is asked for no more. */
  giveUp(why: string): void {
    this.feed.disconnect();
    [this.hasGivenUp, this.trouble] = [true, why];
  }

  /** What the push's own HTTP answer tells, ahead of or instead of the topics. */
  pushed({ id, hash, state, steps, replies }: PushResult, files: readonly SourceFile[], targets: readonly string[]): void {
    const begun = { id, hash, author: "operator", targets: [...targets], files: [...files] };
    let pushes = withPush(this.#team.pushes, begun, Date.now());
    pushes = withProgress(pushes, id, { state, steps });
    for (const reply of replies) pushes = withReply(pushes, id, withDefaults(reply), Date.now());
    this.#hasOtherNews = true;
    this.#fold({ ...this.#team, pushes }, true);
  }

  dismiss(pushId: string): void {
    this.#hasOtherNews = true;
    this.#fold({ ...this.#team, pushes: this.#team.pushes.filter((push) => push.id !== pushId) }, true);
  }

  /** The team at each instant that is kept, the earliest first. */
  get past(): readonly Instant[] {
    return this.#history.instants;
  }

  /** Of a recording its first: it can go there, heard or not. */
  get earliest_ms(): number {
    return this.playback ? this.playback.start_ms : this.#history.earliest_ms ?? this.#clock.now_ms;
  }

  /** Tells `listener` of each message of `topic` as it comes, until the returned function is called. */
  onMessage(topic: string, listener: (message: unknown) => void): () => void {
    return this.#listeners.add(topic, listener);
  }

  /**
   * Tells `listener` when a recording goes on from another instant, until the returned function is called: what is newer
   * has not happened, and what stood before stands no more.
   */
  onRewind(listener: (to_ms: number) => void): () => void {
    this.#rewinders.add(listener);
    return () => void this.#rewinders.delete(listener);
  }

  /** Hands `viewer` each picture of `topic`, which it draws at once, until the returned function is called. */
  onPicture(topic: string, viewer: (picture: DecodedPicture) => void): () => void {
    return this.#viewers.add(topic, viewer);
  }

  #connected(connection: Connection): void {
    this.connection = connection;
    if (this.playback) return;
    if (connection === "live") this.#fold(unwatched(this.#team));
    if (connection === "lost") {
      this.#fold(withSilencesUntil(this.#team, this.#clock.newest_ms(Date.now())));
      this.lost_ms ??= Date.now();
    }
    if (connection !== "live" || this.lost_ms === undefined) return;
    this.gaps = withGap(this.gaps, { from_ms: this.lost_ms, to_ms: Date.now() });
    this.lost_ms = undefined;
    this.#fold({ ...this.#team, pushes: withInterrupted(this.#team.pushes) });
  }

  #take({ news, told_ms, dropped }: Batch): void {
    if (this.playback) this.playback.now_ms = Math.max(this.playback.now_ms, told_ms);
    for (const { topic, message } of news) this.#listeners.tell(topic, message);
    const happened = news.filter(({ topic }) => tellsWhatHappens(topic) && !this.#isAside(topic));
    this.#hasOtherNews ||= happened.some(({ topic }) => !isChange(topic));
    if (told_ms > 0) this.#clock.tell(told_ms);
    if (dropped > 0) this.trouble = `The page slept too long: ${plural(dropped, "event")} of the robots were dropped.`;
    const team = applyAll(this.#team, news);
    // Of a recording everything is told with the times that it had.
    this.#fold(this.playback ? team : watched(team, told_ms), happened.length > 0);
  }

  /**
   * A recording goes on from another instant, as `told` says. How things stood then comes at once, one message after the
   * other: until that has been told, the instant before is shown.
   */
  #rewind(told: (playback: Playback) => void): void {
    if (!this.playback) return;
    const from_ms = this.playback.now_ms;
    told(this.playback);
    const to_ms = this.playback.now_ms;
    // While nothing is shown yet, there is no instant before to be shown: least of all today.
    if (this.#shown === emptyTeam) this.#clock.jump(to_ms);
    const isSettling = this.#gapsThen !== undefined;
    const { team, gaps } = rewound({ team: this.#team, gaps: this.#gapsThen ?? this.gaps }, this.#history, from_ms, to_ms);
    [this.#team, this.#gapsThen] = [team, gaps];
    for (const listener of this.#rewinders) listener(to_ms);
    if (!isSettling) setTimeout(() => this.#settle(), SETTLE_MS);
  }

  #settle(): void {
    [this.gaps, this.#gapsThen] = [this.#gapsThen ?? this.gaps, undefined];
    this.#draw(false);
    this.#tellGlance();
    this.playback?.settled();
    flushSync();
  }

  /** A change of state of a robot that nobody chose comes with what is steady: there may be a hundred such robots. */
  #isAside(topic: string): boolean {
    return isChange(topic) && robotTopicOf(topic)?.robot !== this.robotName;
  }

  // Messages are folded as they come and drawn at most once a frame, however many there are.
  #fold(team: Team, atOnce = false): void {
    if (team === this.#team) return;
    this.#team = team;
    if (atOnce) this.#redraw.askNow();
    this.#redraw.ask();
  }

  /**
   * What has happened is to be seen in the very next frame. What only ages waits for the one after it; where only states have
   * changed, so does all else that is known.
   */
  #draw(isUrgent: boolean): void {
    if (this.#gapsThen) return;
    if (isUrgent && !this.#hasOtherNews) return this.#drawAhead();
    [this.#hasOtherNews, this.#ahead] = [false, undefined];
    if (this.#shown !== this.#team) {
      this.#shown = this.#team;
      this.#history.record(this.#team, this.clock_ms, this.#clock.newest_ms(this.clock_ms));
      // What is forgotten is not shown under its old time.
      if (this.instant_ms !== undefined && this.instant_ms < this.earliest_ms) this.instant_ms = this.earliest_ms;
    }
    if (!isUrgent) this.#advance();
    this.feed.lookAt(this.robotName);
    flushSync();
  }

  #drawAhead(): void {
    this.#ahead = this.#team.robots.get(this.robotName ?? "");
    flushSync();
  }

  /** Whether time must be drawn though nothing else is. */
  get #isDue(): boolean {
    if (this.#gapsThen) return false;
    return this.playback ? this.playback.now_ms !== this.#clock.now_ms : this.#clock.isDue(Date.now());
  }

  #advance(): void {
    const now_ms = this.clock_ms;
    if (this.playback) this.#clock.jump(now_ms);
    else this.#clock.advance(now_ms);
    this.playback?.drawn(now_ms);
    this.#tellGlanceInTurn();
    const silent = silentIn(this.#shown.robots.values(), this.known_present_ms);
    if (!haveSame(silent, this.#silentNow)) this.#silentNow = silent;
  }

  /** A crowd's rows and cells have a frame of their own: in one with the rest it would take too long. */
  #tellGlanceInTurn(): void {
    if (this.#shown.robots.size <= CROWD || this.#glanced.robots.size !== this.#shown.robots.size) return this.#tellGlance();
    if (this.#glanceWaits || this.#frames.now_ms() - this.#glanceTold_ms < GLANCE_MS) return;
    this.#glanceWaits = true;
    const tell = () => {
      this.#glanceWaits = false;
      this.#tellGlance();
      flushSync();
    };
    this.#frames.before(() => this.#frames.behind(tell));
  }

  #tellGlance(): void {
    this.#glanceTold_ms = this.#frames.now_ms();
    [this.#glanced, this.#glanced_ms] = [this.#shown, this.clock_ms];
    this.#clock.step(this.clock_ms);
  }
}

const isChange = (topic: string) => robotTopicOf(topic)?.kind === "transition";

const inTheirOrder = ({ robots }: Team) => [...robots.values()].sort((a, b) => a.identity.index - b.identity.index);

/** Where the address has a recording begin; undefined: at its start. */
function secondsIn(search: string): number | undefined {
  const at_s = Number(new URLSearchParams(search).get("at") ?? Number.NaN);
  return Number.isFinite(at_s) && at_s >= 0 ? at_s : undefined;
}

function withDefaults(reply: Partial<Reply> & Pick<Reply, "robot" | "status">): Reply {
  return {
    hash: "",
    running_hash: "",
    message: "",
    swap_tick_us: 0,
    kept_variables: [],
    diagnostics: [],
    ...reply,
  };
}

export const live = new Live();
