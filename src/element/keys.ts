/** Hot keys: the thesis' own where it has one, and what drawing programs share. They answer only while the element has focus. */
import { dropBend, keepBend, startBend } from './bending.ts';
import { dragOf, keyOf } from './lookKeys.ts';
import {
  duplicateSelection,
  hideSelection,
  letGoOf,
  mirrorSelection,
  removeSelection,
  selectAll,
} from './partDeeds.ts';
import { leaveRedraw, startRedraw } from './redraws.ts';
import type { Session } from './session.ts';
import { leaveSkeleton, removeNode, toggleSkeleton } from './skeletonEdit.ts';
import { type ShownStyle, STYLE_NAMES } from './words.ts';

export interface KeyActions {
  stepRadius(direction: 1 | -1): void;
  toggleHelp(): void;
  /** Escape with nothing pending */
  close(): void;
  /** looking only: keys that edit mean nothing */
  readonly readOnly: boolean;
  /** `as`: to another file */
  save(as: boolean): void;
  openFile(): void;
}

const STYLES = Object.keys(STYLE_NAMES) as ShownStyle[];

/** Carries the key out; false when it means nothing here. */
export function press(event: KeyboardEvent, session: Session, actions: KeyActions): boolean {
  const command = event.ctrlKey || event.metaKey;
  const key = keyOf(event);
  if (command && key === 'z' && !actions.readOnly)
    return done(event.shiftKey ? session.redo() : session.undo());
  if (command && key === 'y' && !actions.readOnly) return done(session.redo());
  if (command && key === 's' && !actions.readOnly) return done(actions.save(event.shiftKey));
  if (command && key === 'o' && !actions.readOnly) return done(actions.openFile());
  if (command && key === 'a' && !actions.readOnly) return done(selectAll(session));
  if (command && key === 'd' && !actions.readOnly) return duplicateSelection(session);
  if (command || event.altKey) return false;
  if (key in STYLES_BY_KEY) return done(chooseStyle(session, STYLES_BY_KEY[key]!));
  if (actions.readOnly && key === 'Escape') return done(actions.close());
  if (!actions.readOnly && drawing(key, event.shiftKey, session, actions)) return true;
  return looking(key, session, actions);
}

const STYLES_BY_KEY: Readonly<Record<string, ShownStyle>> = Object.fromEntries(
  STYLES.map((style, i) => [String(i + 1), style]),
);

const chooseStyle = (session: Session, style: ShownStyle) => session.setStyle(style, STYLE_NAMES[style]);

function drawing(key: string, shift: boolean, session: Session, actions: KeyActions): boolean {
  switch (key) {
    case 'n':
    case 'Enter':
      return done(session.tool === 'bend' ? keepBend(session) : session.keep());
    case 'Escape':
      return done(back(session, actions));
    case 'u':
      return done(session.undo());
    case 'z':
      return shift && done(session.redo());
    case 'q':
      return done(actions.stepRadius(shift ? -1 : 1));
    case 'c':
      return done(session.run({ type: 'removeLast' }));
    case 'e':
      return done(session.run({ type: 'removeAll' }));
    case 'd':
      session.setTool('draw');
      return done(actions.close());
    case 'o':
      return startRedraw(session);
    case 'b':
      return startBend(session);
    case 'l':
      session.setTool('section');
      return done(actions.close());
    case 'v':
      return done(session.setTool('select'));
    case 'm':
      return shift && mirrorSelection(session);
    case 'h':
      return hideSelection(session);
    case 'k':
      return toggleSkeleton(session);
    case 'Delete':
    case 'Backspace':
      return removeNode(session) || removeSelection(session);
    default:
      return false;
  }
}

/**
 * Escape takes back what is most in the hand: the gesture under way, what the Select tool holds (from a group up to its part), the unfinished form;
 * then the panel closes.
 */
function back(session: Session, actions: KeyActions): void {
  if (session.cancel()) return;
  if (session.tool === 'bend') {
    dropBend(session);
    return;
  }
  if (session.tool === 'redraw' && !session.document.draft) {
    leaveRedraw(session);
    return;
  }
  if (leaveSkeleton(session)) return;
  if (letGoOf(session)) return;
  if (session.document.draft) session.drop();
  else actions.close();
}

function looking(key: string, session: Session, actions: KeyActions): boolean {
  const { look } = session;
  const drag = dragOf(key);
  if (drag) return done(session.camera.orbit(...drag));
  switch (key) {
    case 'g':
      return done(session.setLook({ grid: !look.grid }));
    case 'p':
      return done(session.setLook({ grain: !look.grain }));
    case 'w':
      return done(session.setLook({ wireframe: !look.wireframe }));
    case 'x':
      return done(session.setMode(look.mode === 'exact' ? 'mesh' : 'exact'));
    case 'm':
      return done(session.looks.toggleVolumes());
    case 'f':
      return done(session.onFullScreen());
    case 'Home':
      return done(session.camera.showAll());
    case '0':
      return done(session.camera.reset());
    case '?':
      return done(actions.toggleHelp());
    default:
      return false;
  }
}

const done = (_: unknown): true => true;
