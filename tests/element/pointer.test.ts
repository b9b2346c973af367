/** The pointer router on a canvas that is none: palms, second fingers and lost pointers. */
import { beforeEach, describe, expect, it } from 'vitest';
import { PointerRouter, type PointerTarget } from '../../src/element/pointer.ts';

class FakeCanvas extends EventTarget {
  readonly clientWidth = 800;
  readonly clientHeight = 600;
  focus(): void {}
  setPointerCapture(): void {}
  getBoundingClientRect() {
    return { left: 0, top: 0 };
  }
}

let canvas: FakeCanvas;
let log: string[];
let fingersDraw: boolean;
let looking: boolean;
const touching = new Set<number>();

beforeEach(() => {
  canvas = new FakeCanvas();
  log = [];
  touching.clear();
  fingersDraw = true;
  looking = false;
  const note = (name: string) => () => void log.push(name);
  const target: PointerTarget = {
    down: note('down'),
    erase: note('erase'),
    move: note('move'),
    hover: (pen) => void log.push(pen ? 'hover' : 'left'),
    up: note('up'),
    cancel: note('cancel'),
    orbit: note('orbit'),
    pan: note('pan'),
    roll: note('roll'),
    zoom: note('zoom'),
    focus: note('focus'),
    undo: note('undo'),
    redo: note('redo'),
    tap: note('tap'),
    looking: () => looking,
    penSeen: note('pen seen'),
    fingersDraw: () => fingersDraw,
  };
  new PointerRouter(canvas as unknown as HTMLElement, target);
});

function send(type: string, pointerType: string, pointerId: number, x = 100, button = 0): void {
  if (type === 'pointerdown') touching.add(pointerId);
  if (type === 'pointerup' || type === 'pointercancel') touching.delete(pointerId);
  const event = new Event(type, { cancelable: true });
  const facts = {
    pointerType,
    pointerId,
    clientX: x,
    clientY: 100,
    button,
    buttons: touching.has(pointerId) ? 1 : 0,
    pressure: 0.5,
    tiltX: 0,
    tiltY: 0,
  };
  canvas.dispatchEvent(Object.assign(event, facts));
}

const strokes = () => log.filter((name) => ['down', 'up', 'cancel'].includes(name));

describe('what does not touch', () => {
  it('hovers and leaves; a finger does neither', () => {
    send('pointermove', 'pen', 1, 150);
    send('pointermove', 'mouse', 2, 150);
    send('pointerleave', 'mouse', 2);
    send('pointerleave', 'touch', 7);
    expect(log).toEqual(['hover', 'hover', 'left']);
  });

  it('hovers no more while it draws', () => {
    send('pointerdown', 'mouse', 2);
    log.length = 0;
    send('pointermove', 'mouse', 2, 150);
    send('pointerleave', 'mouse', 2);
    expect(log).toEqual(['move']);
  });
});

describe('a pen', () => {
  it('draws on while a palm touches and leaves', () => {
    send('pointerdown', 'pen', 1);
    send('pointermove', 'pen', 1, 150);
    send('pointerdown', 'touch', 7);
    send('pointerup', 'touch', 7);
    send('lostpointercapture', 'touch', 7);
    const before = log.length;
    send('pointermove', 'pen', 1, 200);
    expect(log.slice(before)).toEqual(['move']);
    send('pointerup', 'pen', 1, 200);
    expect(strokes()).toEqual(['down', 'up']);
  });

  it('draws on when the system cancels the palm, or a mouse button is released', () => {
    send('pointerdown', 'pen', 1);
    send('pointerdown', 'touch', 7);
    send('pointercancel', 'touch', 7);
    send('pointerup', 'mouse', 2);
    send('pointerup', 'pen', 1);
    expect(strokes()).toEqual(['down', 'up']);
  });

  it('withdraws what a palm had begun, however long before', () => {
    send('pointerdown', 'touch', 7);
    send('pointermove', 'touch', 7, 160);
    send('pointerdown', 'pen', 1);
    send('pointerup', 'pen', 1);
    expect(strokes()).toEqual(['down', 'cancel', 'down', 'up']);
  });

  it('cancels when it is lost', () => {
    send('pointerdown', 'pen', 1);
    send('pointercancel', 'pen', 1);
    send('pointerdown', 'pen', 2);
    send('pointerup', 'pen', 2);
    expect(strokes()).toEqual(['down', 'cancel', 'down', 'up']);
  });

  it('draws over with its eraser and turns nothing meanwhile', () => {
    fingersDraw = false;
    send('pointerdown', 'touch', 7);
    send('pointerdown', 'pen', 1, 100, 5);
    send('pointermove', 'pen', 1, 200);
    send('pointerup', 'pen', 1, 200);
    expect(log.filter((name) => name !== 'pen seen')).toEqual(['erase', 'move', 'move', 'up']);
  });
});

describe('fingers', () => {
  it('cancel a stroke with the second one', () => {
    send('pointerdown', 'touch', 1);
    send('pointerdown', 'touch', 2, 300);
    expect(strokes()).toEqual(['down', 'cancel']);
  });

  it('turn the view once they do not draw', () => {
    fingersDraw = false;
    send('pointerdown', 'touch', 1);
    send('pointermove', 'touch', 1, 140);
    expect(log).toEqual(['orbit']);
  });
});

describe('where people may only look', () => {
  beforeEach(() => {
    looking = true;
  });

  for (const pointer of ['pen', 'mouse', 'touch']) {
    it(`a drag with ${pointer} turns the view and selects nothing`, () => {
      send('pointerdown', pointer, 1);
      send('pointermove', pointer, 1, 150);
      send('pointerup', pointer, 1, 150);
      expect(log.filter((name) => name !== 'pen seen')).toEqual(['orbit']);
    });

    it(`a tap with ${pointer} selects`, () => {
      send('pointerdown', pointer, 1);
      send('pointerup', pointer, 1);
      expect(log.filter((name) => name !== 'pen seen')).toEqual(['tap']);
    });
  }

  it('the right button turns, and selects nothing', () => {
    send('pointerdown', 'mouse', 1, 100, 2);
    send('pointerup', 'mouse', 1, 100, 2);
    expect(log).toEqual([]);
  });
});
