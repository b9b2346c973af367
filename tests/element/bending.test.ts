/** How the Bend tool is taken up, and laid down. */
import { beforeAll, expect, test, vi } from 'vitest';
import { isSurface } from '../../src/document/document.ts';
import { EMPTY_DRAWING } from '../../src/document/drawing.ts';
import { dropBend, editBend, keepBend, setBendLength, startBend } from '../../src/element/bending.ts';
import { startRedraw } from '../../src/element/redraws.ts';
import { Session } from '../../src/element/session.ts';
import { CameraRig } from '../../src/scene/cameraRig.ts';
import type { Scene } from '../../src/scene/index.ts';
import { bendPart, madeBend } from '../../src/tool/bend.ts';
import type { Pen } from '../../src/tool/tool.ts';
import { strokeAlong } from '../document/strokes.ts';

// camera-controls keeps rectangles of the page it is never connected to.
beforeAll(() => void vi.stubGlobal('DOMRect', class {}));

const line = (x: number) => strokeAlong((t) => [x, 60 * t - 30]);

function session(): Session {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.size = { width: 800, height: 600 };
  session.open(EMPTY_DRAWING, { fresh: true });
  session.commit([{ type: 'addStroke', stroke: line(0) }, { type: 'keep' }]);
  session.select(['part-1']);
  return session;
}

/** By what the tool does, so that the pen need not know where the camera is. */
function draw(session: Session, to: number): void {
  const pen = (i: number): Pen => ({
    x: 400 + ((to - 400) * i * i) / 400,
    y: 550 - 25 * i,
    pressure: 0.5,
    tiltX: 0,
    tiltY: 0,
    time: 8 * i,
    pointer: 'pen',
  });
  session.down(pen(0));
  session.move(Array.from({ length: 20 }, (_, i) => pen(i + 1)));
  session.up();
}

const bends = ({ document: { parts } }: Session) => {
  const [part] = parts;
  return part && isSurface(part) ? part.bends : [];
};

test('Drop takes back the bend, whatever number of strokes it took, in one step; undo brings it back', () => {
  const hand = session();
  startBend(hand);
  for (const to of [500, 300, 450]) draw(hand, to);
  expect(bends(hand)).toHaveLength(1);
  const bent = hand.document;
  const steps = hand.history.past.length;
  dropBend(hand);
  expect(bends(hand)).toHaveLength(0);
  expect(hand.history.past).toHaveLength(steps + 1);
  expect(hand.state.bending).toBeUndefined();
  hand.undo();
  expect(hand.document).toBe(bent);
  expect(hand.state.bending).toBeUndefined();
});

test('a bend drawn anew is as it was after Drop, also where its length was changed on the way', () => {
  const hand = session();
  startBend(hand);
  draw(hand, 500);
  keepBend(hand);
  const [old] = bends(hand);
  editBend(hand, 'part-1', 0);
  draw(hand, 300);
  setBendLength(hand, false);
  draw(hand, 350);
  dropBend(hand);
  expect(bends(hand)).toEqual([old]);
});

test('undone beneath it, the bend in hand is the next one there, and is kept or dropped as such', () => {
  const hand = session();
  for (const to of [500, 300]) {
    startBend(hand);
    draw(hand, to);
    keepBend(hand);
  }
  expect(bends(hand)).toHaveLength(2);
  editBend(hand, 'part-1', 1);
  hand.undo();
  hand.undo();
  expect(bends(hand)).toHaveLength(0);
  draw(hand, 450);
  expect(bends(hand)).toHaveLength(1);
  expect(madeBend(hand.state.bending!, hand.document)).toBe(bends(hand)[0]);
  dropBend(hand);
  expect(bends(hand)).toHaveLength(0);
});

test('strokes in hand go back to their part, and that is bent, whatever was made after it', () => {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open(EMPTY_DRAWING, { fresh: true });
  for (const x of [0, 40]) session.commit([{ type: 'addStroke', stroke: line(x) }, { type: 'keep' }]);
  session.commit([{ type: 'recreate', id: 'part-1' }]);
  startBend(session);
  expect(session.document.draft).toBeNull();
  expect(session.selection).toEqual(['part-1']);
  expect(session.state.bending?.id).toBe('part-1');
});

test('where there is nothing to bend words say so, and the pen draws on', () => {
  const session = new Session({ changed() {}, drawn() {}, committed() {}, selected() {}, moded() {} });
  session.frames.asleep = true;
  session.open(EMPTY_DRAWING, { fresh: true });
  startBend(session);
  expect(session.tool).toBe('draw');
  expect(session.said).toContain('draw a form first');
});

test('what was dropped is said; laid down with nothing bent, only that', () => {
  const hand = session();
  startBend(hand);
  dropBend(hand);
  expect(hand.said).toBe('Bend put away');
  startBend(hand);
  draw(hand, 500);
  dropBend(hand);
  expect(hand.said).toContain('bend 1 of Tube 1 removed');
});

/** With a camera of its own, whose moves take time. */
function seen(): { readonly hand: Session; readonly rig: CameraRig } {
  const hand = session();
  const rig = new CameraRig();
  hand.scene = { rig, setFaint() {}, select() {} } as unknown as Scene;
  return { hand, rig };
}

const settle = (rig: CameraRig) => rig.update(10);

test('taken up again while the camera turns back, or to the side, it goes home to where one looked from at first', () => {
  const { hand, rig } = seen();
  const home = hand.view;
  for (let i = 0; i < 3; i++) {
    startBend(hand);
    rig.update(0.1);
    expect(hand.view.rotation).not.toEqual(home.rotation);
    dropBend(hand);
    rig.update(0.1);
  }
  expect(hand.view.rotation).not.toEqual(home.rotation);
  // a tap on the part, too
  hand.setTool('bend');
  hand.begin(bendPart(hand, 'part-1', 0));
  settle(rig);
  expect(hand.view.rotation).not.toEqual(home.rotation);
  dropBend(hand);
  settle(rig);
  expect(hand.view).toEqual(home);
});

test('taken up while the camera comes to another view, it goes home to that one', () => {
  const { hand, rig } = seen();
  const back = { ...hand.view, rotation: [0, 1, 0, 0] } as const;
  hand.lookFrom(back);
  rig.update(0.1);
  startBend(hand);
  settle(rig);
  dropBend(hand);
  settle(rig);
  expect(hand.view).toEqual(back);
});

test('a hand that turned the camera on its way says where home is', () => {
  const { hand, rig } = seen();
  startBend(hand);
  settle(rig);
  dropBend(hand);
  rig.update(0.1);
  hand.camera.orbit(10, 0);
  const turned = hand.view;
  startBend(hand);
  settle(rig);
  dropBend(hand);
  settle(rig);
  expect(hand.view.rotation).toEqual(turned.rotation);
});

test.each(['bend', 'redraw'] as const)(
  'another tool taken up before anything was drawn: %s is put away',
  (tool) => {
    const hand = session();
    if (tool === 'bend') startBend(hand);
    else startRedraw(hand);
    hand.setTool('select');
    expect(hand.said).toBe(tool === 'bend' ? 'Bend put away' : 'Redraw put away');
  },
);
