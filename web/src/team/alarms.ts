import { isSilent } from "./silence";
import type { Team } from "./model";

/** What an operator must hear of, one sentence each. */
export function alarms(team: Team, now_ms: number): string[] {
  const ofRobots = [...team.robots.values()].flatMap((robot) => [
    ...(isSilent(robot, now_ms) ? [`${robot.name} is silent.`] : []),
    ...(robot.state?.value.problems ?? []).map((problem) => `${robot.name}: ${problem}`),
  ]);
  const ofPushes = team.pushes.flatMap((push) =>
    [...push.replies.values()]
      .filter(({ status }) => status === "rejected" || status === "rolled_back")
      .map(({ robot, status }) => `${robot} ${status === "rejected" ? "refused" : "went back from"} ${push.name}.`),
  );
  return [...ofRobots, ...ofPushes];
}
