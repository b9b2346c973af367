/** Colours, type, sizes and motion of the interface: light, dark and high contrast. */
import { css, unsafeCSS } from 'lit';

const LIGHT = `
  --paper: #f6f1e6; --surface: #fffdf8; --sunken: #f1ebde; --hairline: #e3dac9; --edge: #857b69; --track: #d8cdb9;
  --ink: #26211b; --ink-2: #5c5447; --ink-off: #a39a89;
  --pencil: #2b59c3; --pencil-press: #214697; --pencil-soft: #e4ebfa; --on-pencil: #ffffff;
  --active: #2a2520; --on-active: #fffdf8; --good: #2e7045; --warn: #825300; --danger: #ae3227;
  --axis-x: #b93a30; --axis-y: #2f7d49; --axis-z: #2b59c3; --axis-view: #e0a526; --on-axis-view: #26211b;
  --e1: 0 1px 2px rgb(70 50 20 / .07), 0 3px 12px rgb(70 50 20 / .07);
  --e2: 0 2px 4px rgb(70 50 20 / .08), 0 12px 32px rgb(70 50 20 / .13);
  color-scheme: light;`;

const DARK = `
  --paper: #191e2b; --surface: #242b3a; --sunken: #1c2230; --hairline: #353e51; --edge: #8791a6; --track: #4a556c;
  --ink: #f2ecdf; --ink-2: #b9bfcc; --ink-off: #6e788c;
  --pencil: #93b4ff; --pencil-press: #b3caff; --pencil-soft: #2c3a5e; --on-pencil: #121724;
  --active: #f2ecdf; --on-active: #1d2331; --good: #86cf9c; --warn: #e8b65a; --danger: #ff9a8c;
  --axis-x: #ff8a7d; --axis-y: #7fd39a; --axis-z: #93b4ff; --axis-view: #f0c25a; --on-axis-view: #1d2331;
  --e1: 0 1px 2px rgb(0 0 0 / .3), 0 4px 14px rgb(0 0 0 / .28);
  --e2: 0 2px 6px rgb(0 0 0 / .35), 0 14px 36px rgb(0 0 0 / .45);
  color-scheme: dark;`;

const CONTRAST = `
  --paper: #ffffff; --surface: #ffffff; --sunken: #ffffff; --hairline: #000000; --edge: #000000; --track: #8c8c8c;
  --ink: #000000; --ink-2: #1f1f1f; --ink-off: #6b6b6b;
  --pencil: #0033a8; --pencil-press: #001f6b; --pencil-soft: #dfe8ff; --on-pencil: #ffffff;
  --active: #000000; --on-active: #ffffff; --good: #00541f; --warn: #5e3a00; --danger: #930c00;
  --axis-x: #930c00; --axis-y: #00541f; --axis-z: #0033a8; --axis-view: #8a6200; --on-axis-view: #ffffff;
  --e1: 0 0 0 1px #000; --e2: 0 0 0 2px #000;
  color-scheme: light;`;

/** `data-theme` is set by the element, from its `theme` attribute or the system's settings. */
export const tokens = css`
  :host {
    --font: -apple-system, 'SF Pro Text', 'Segoe UI', Roboto, Inter, 'Liberation Sans', 'DejaVu Sans', sans-serif;
    --press: 90ms;
    --appear: 160ms;
    --out: cubic-bezier(0.2, 0.8, 0.2, 1);
    ${unsafeCSS(LIGHT)}
  }
  :host([data-theme='dark']) { ${unsafeCSS(DARK)} }
  :host([data-theme='contrast']) { ${unsafeCSS(CONTRAST)} }
  /* what lies on the picture itself is read against its paper, whatever the theme */
  .app { --over: #26211b; --over-2: #5c5447; --halo: #f6f1e6; }
  .app.on-dark { --over: #f2ecdf; --over-2: #b9bfcc; --halo: #191e2b; }
  :host([data-theme='contrast']) .app:not(.on-dark) { --over: #000000; --over-2: #1f1f1f; --halo: #ffffff; }
  :host([data-theme='contrast']) .app.on-dark { --over: #ffffff; --over-2: #ffffff; }
  @media (prefers-reduced-motion: reduce) {
    :host { --press: 1ms; --appear: 1ms; }
  }
`;
