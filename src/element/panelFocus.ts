/** Focus goes into a panel when it opens and back to what opened it when it closes; it is never taken from elsewhere. */

export class PanelFocus {
  #opener: HTMLElement | null = null;

  /** After an update that opened, changed or closed a panel. `home` has the focus when nothing else can. */
  moved(root: ShadowRoot, home: HTMLElement): void {
    const panel = root.querySelector<HTMLElement>('.panel');
    const focused = root.activeElement as HTMLElement | null;
    if (!panel) {
      if (!focused) this.#back(root, home);
      this.#opener = null;
      return;
    }
    if (panel.contains(focused)) return;
    // What was in the panel before this one went with it: the first opener stays the way back.
    if (focused && focused !== home) this.#opener = focused;
    panel.focus({ preventScroll: true });
  }

  #back(root: ShadowRoot, home: HTMLElement): void {
    const opener = this.#opener;
    const there = opener && root.contains(opener) && opener.checkVisibility();
    (there ? opener : home).focus({ preventScroll: true });
  }
}
