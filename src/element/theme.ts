/** What the system asks for: light or dark, more contrast, less motion. */
import type { Look } from '../document/look.ts';

export type Theme = 'light' | 'dark' | 'contrast';

const DARK = '(prefers-color-scheme: dark)';
const CONTRAST = '(prefers-contrast: more)';
const STILL = '(prefers-reduced-motion: reduce)';

export function systemTheme(): Theme {
  if (matchMedia(CONTRAST).matches) return 'contrast';
  return matchMedia(DARK).matches ? 'dark' : 'light';
}

/** A name that is none is no theme. */
export const themeOf = (name: string | null): Theme =>
  name !== null && Object.hasOwn(PAPER_OF, name) ? (name as Theme) : systemTheme();

export const reducedMotion = (): boolean => matchMedia(STILL).matches;

export function watchSystem(changed: () => void, signal: AbortSignal): void {
  for (const query of [DARK, CONTRAST, STILL])
    matchMedia(query).addEventListener('change', changed, { signal });
}

/** A window moved to another screen changes its pixels without changing its size. */
export function watchPixelRatio(changed: () => void, signal: AbortSignal): void {
  const arm = () =>
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', again, {
      once: true,
      signal,
    });
  const again = () => {
    changed();
    arm();
  };
  arm();
}

/** The paper that goes with a theme, until a person chooses one. */
export const PAPER_OF: Readonly<Record<Theme, Pick<Look, 'background' | 'grain'>>> = {
  light: { background: 'paper', grain: true },
  dark: { background: 'blue', grain: true },
  contrast: { background: 'white', grain: false },
};
