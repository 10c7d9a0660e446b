// SPDX-License-Identifier: BSD-3-Clause
import { CAMERA, type Picture } from "../feed/topics";

/** What the reader chose to see of the robots' pictures; it outlives the panel. */
class VisionChoice {
  /** The picture that is shown large, or of every robot. */
  picture = $state<Picture>(CAMERA);
  everyRobot = $state(false);
  /** Horizon and ranges are drawn over the camera's picture. */
  scale = $state(true);
  tuning = $state(false);
}

export const visionChoice = new VisionChoice();
