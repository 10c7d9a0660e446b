// SPDX-License-Identifier: BSD-3-Clause
// The panels that there are: a new one is one line. Phones show them as tabs in this order, and the keys
// 1, 2, 3 … bring them into sight.

import type { Component } from "svelte";
import { instructor } from "../model/instructor.svelte";
import type { PanelName } from "../layout/arrangement.svelte";
import { BREAK, BREAKS, COVERAGE } from "../machine/keys";
import MachinePanel from "../machine/MachinePanel.svelte";
import GainsPanel from "../gains/GainsPanel.svelte";
import InstructorPanel from "../instructor/InstructorPanel.svelte";
import MapPanel from "../map/MapPanel.svelte";
import PlotsPanel from "../plots/PlotsPanel.svelte";
import { EDIT } from "../program/keys";
import ProgramPanel from "../program/ProgramPanel.svelte";
import RefereePanel from "../referee/RefereePanel.svelte";
import TeamPanel from "../team/TeamPanel.svelte";
import TimelinePanel from "../timeline/TimelinePanel.svelte";
import VariablesPanel from "../variables/VariablesPanel.svelte";
import { EVERY_ROBOT } from "../vision/keys";
import VisionPanel from "../vision/VisionPanel.svelte";
import WhyPanel from "../why/WhyPanel.svelte";

export interface PanelKind extends PanelName {
  readonly component: Component;
  /** Keys of the panel that bring it into sight where it is not, with what they do. */
  readonly keys?: readonly (readonly [key: string, does: string])[];
}

/** `behind` puts a panel that STANDARD does not place as a tab of another. */
export const panels: readonly PanelKind[] = [
  {
    id: "map",
    title: "Map",
    about: "Where every robot and object is, as the team knows it together: fainter is less sure, the ellipse is where it may be.",
    component: MapPanel,
  },
  {
    id: "team",
    title: "Team",
    about: "Each robot with its state, program and health. Hold, start, resume, take out of service; alarms stay until they are seen.",
    component: TeamPanel,
  },
  {
    id: "machine",
    title: "State machine",
    about: "The chosen robot's states: the current one is filled, blue arrows fired lately, a dashed arrow is near to firing. Point at a state to see its conditions as they stand. ● stops the robot there, ■ waits until somebody lets it through.",
    component: MachinePanel,
    keys: [COVERAGE, BREAK, BREAKS],
  },
  {
    id: "why",
    title: "Why",
    about: "Each change of state with its cause, the line of the program, what else could have fired, and what the robot knew then.",
    component: WhyPanel,
  },
  {
    id: "variables",
    title: "Variables",
    about: "What the chosen robot knows, and how sure it is of it: bars shrink until it forgets. Click a number to plot it, a force's arrow to see it on the map.",
    component: VariablesPanel,
  },
  {
    id: "vision",
    title: "Vision",
    about: "What the chosen robot's camera sees, and what it takes for objects. Tune tries other thresholds on the picture.",
    component: VisionPanel,
    keys: [EVERY_ROBOT],
  },
  {
    id: "plots",
    title: "Plots",
    about: "Numbers over time, along the timeline's axis. Point at an instant to read all of them, click to show everything as it was then.",
    component: PlotsPanel,
    behind: "vision",
  },
  {
    id: "timeline",
    title: "Timeline",
    about: "What every robot did, and when: states as bars, ◆ pieces thrown away, ✕ collisions, ▲ pushes, and who was held or stopped. Click to see everything as it was; the wheel zooms.",
    component: TimelinePanel,
  },
  {
    id: "program",
    title: "Program",
    about: "What runs, and what would: check, try, push to one robot first or to all, roll back. Every push is kept in the history.",
    component: ProgramPanel,
    keys: [EDIT],
  },
  {
    id: "referee",
    title: "Referee",
    about: "The contest's clock, score and penalties, each call, and how the programs compare that were run in it.",
    component: RefereePanel,
    behind: "why",
  },
  {
    id: "gains",
    title: "Gains",
    about: "Gains and thresholds of the running program, to be moved while it runs: each goes the way of a push as soon as the hand rests, and into the draft.",
    component: GainsPanel,
    behind: "program",
  },
  {
    id: "instructor",
    title: "Instructor",
    about: "What an instructor does to the running simulation: its clock and contest, broken parts, pieces, pushes, and what stands where. It is there only where a simulation is.",
    component: InstructorPanel,
    behind: "machine",
    onRequest: true,
    isOffered: () => instructor.isOffered,
  },
];
