// The panels that there are: a new one is one line. Phones show them as tabs in this order, and the keys
// 1, 2, 3 … bring them into sight.

import type { Component } from "svelte";
import type { PanelName } from "../layout/arrangement.svelte";
import MachinePanel from "./MachinePanel.svelte";
import MapPanel from "./MapPanel.svelte";
import PlotsPanel from "./PlotsPanel.svelte";
import ProgramPanel from "./ProgramPanel.svelte";
import RefereePanel from "./RefereePanel.svelte";
import TeamPanel from "./TeamPanel.svelte";
import TimelinePanel from "./TimelinePanel.svelte";
import VariablesPanel from "./VariablesPanel.svelte";
import VisionPanel from "./VisionPanel.svelte";
import WhyPanel from "./WhyPanel.svelte";

export interface PanelKind extends PanelName {
  readonly component: Component;
}

/** `behind` puts a panel that STANDARD does not place as a tab of another. */
export const panels: readonly PanelKind[] = [
  { id: "map", title: "Map", component: MapPanel },
  { id: "team", title: "Team", component: TeamPanel },
  { id: "machine", title: "State machine", component: MachinePanel },
  { id: "why", title: "Why", component: WhyPanel },
  { id: "variables", title: "Variables", component: VariablesPanel },
  { id: "vision", title: "Vision", component: VisionPanel },
  { id: "plots", title: "Plots", component: PlotsPanel, behind: "vision" },
  { id: "timeline", title: "Timeline", component: TimelinePanel },
  { id: "program", title: "Program", component: ProgramPanel },
  { id: "referee", title: "Referee", component: RefereePanel, behind: "why" },
];

/** Where each stands until somebody arranges them, as layout/text.ts writes it. */
export const STANDARD =
  "r(73-c(53-r(30-c(45-team.55-program).70-map).18-timeline.29-r(57-variables.43-vision)).27-c(71-machine.29-why))";
