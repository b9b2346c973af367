/** Pointers, keys and the view ball on the field page: all of them only look. */
import type { CameraRig } from '../../scene/index.ts';
import { dragOf, keyOf } from '../lookKeys.ts';
import type { PointerTarget } from '../pointer.ts';
import type { BallActions } from '../viewBall.ts';

interface HandsHost {
  /** null while there is no scene */
  readonly rig: CameraRig | null;
  /** another frame is wanted */
  wake(): void;
  showAll(animate: boolean): void;
  reset(): void;
  /** by its number, from 1; false where there is none */
  setStyle(number: number): boolean;
  toggleWires(): void;
  toggleRays(): void;
  toggleVolumes(): void;
}

const NEARER = 1.15;

export class FieldHands {
  readonly #host: HandsHost;

  constructor(host: HandsHost) {
    this.#host = host;
  }

  /** What the router calls where nothing can be drawn. */
  target(): PointerTarget {
    const nothing = () => {};
    return {
      down: nothing,
      move: nothing,
      hover: nothing,
      erase: nothing,
      up: nothing,
      cancel: nothing,
      undo: nothing,
      redo: nothing,
      tap: nothing,
      penSeen: nothing,
      fingersDraw: () => false,
      looking: () => true,
      focus: () => this.#host.showAll(true),
      orbit: (dx, dy) => this.#move((rig) => rig.orbit(dx, dy)),
      pan: (dx, dy) => this.#move((rig) => rig.pan(dx, dy)),
      roll: (angle) => this.#move((rig) => rig.roll(angle)),
      zoom: (factor, x, y) => this.#move((rig) => rig.zoom(factor, x, y)),
    };
  }

  ball(): BallActions {
    return {
      orbit: (dx, dy) => this.#move((rig) => rig.orbit(dx, dy)),
      face: (axis) => this.#move((rig) => rig.face(axis, true)),
      reset: () => this.#host.reset(),
    };
  }

  /** For the picture, while it has the focus. */
  key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (this.#press(keyOf(event))) event.preventDefault();
  }

  #press(key: string): boolean {
    const drag = dragOf(key);
    if (drag) return this.#move((rig) => rig.orbit(...drag));
    switch (key) {
      case '+':
      case '=':
        return this.#move((rig) => rig.zoom(NEARER));
      case '-':
        return this.#move((rig) => rig.zoom(1 / NEARER));
      case 'Home':
        this.#host.showAll(true);
        return true;
      case '0':
        this.#host.reset();
        return true;
      case 'w':
        this.#host.toggleWires();
        return true;
      case 'x':
        this.#host.toggleRays();
        return true;
      case 'm':
        this.#host.toggleVolumes();
        return true;
      default:
        return this.#host.setStyle(Number(key));
    }
  }

  #move(move: (rig: CameraRig) => void): true {
    const { rig } = this.#host;
    if (rig) move(rig);
    this.#host.wake();
    return true;
  }
}
