// SPDX-License-Identifier: BSD-3-Clause
/** Whether an element can be seen, so that no work is done for what is scrolled away. */
export class InSight {
  now = $state(true);

  readonly attach = (element: Element): (() => void) => {
    const observer = new IntersectionObserver((entries) => (this.now = entries.at(-1)!.isIntersecting));
    observer.observe(element);
    return () => observer.disconnect();
  };
}
