/**
 * When the picture is drawn, and of what: pointer moves only mark what is stale, the frame builds it, and a preview
 * that takes long waits its turn, so that the pen keeps its pace.
 */
import { draftSolids, type Solid, solids } from '../document/build.ts';
import type { Document } from '../document/document.ts';
import type { Look } from '../document/look.ts';
import type { SceneItem } from '../scene/index.ts';
import type { View } from '../stroke/stroke.ts';
import { shownBodies } from './exact.ts';
import type { Session } from './session.ts';
import { guidesOf } from './volumes.ts';
import { WORDS } from './words.ts';

/** ms: a preview that takes longer is not made in every frame */
const SLOW_PREVIEW = 30;

interface Shown {
  readonly solid: Solid;
  readonly preview: boolean;
}

export class Frames {
  /** of all that is shown */
  triangles = 0;
  /** ms the last surface took, from strokes to mesh */
  buildTime = 0;
  #fit = false;
  /** what was fitted to drafts; null: nothing was */
  #fitted: View | null = null;
  readonly #session: Session;
  readonly #drawn: () => void;
  /** rises with every change of what the picture shows, but for the view */
  version = 0;
  #items: readonly SceneItem[] = [];
  #look: Look | null = null;
  #asleep = false;
  #stale = true;
  /** of the request for the next one, or 0 */
  #frame = 0;
  #last = 0;
  #synced = 0;

  constructor(session: Session, drawn: () => void) {
    this.#session = session;
    this.#drawn = drawn;
  }

  /** The whole form is to be seen as soon as there is a scene. */
  get fit(): boolean {
    return this.#fit;
  }

  set fit(on: boolean) {
    this.#fit = on;
    this.#fitted = null;
  }

  /** Nobody can see it: no frames. What is stale stays so until somebody can. */
  get asleep(): boolean {
    return this.#asleep;
  }

  set asleep(on: boolean) {
    this.#asleep = on;
    if (!on) this.wake();
  }

  /** Something the picture shows has changed. */
  mark(): void {
    this.#stale = true;
    this.wake();
  }

  /** One more frame, for a moving camera. */
  wake(): void {
    if (!this.#asleep) this.#frame ||= requestAnimationFrame((now) => this.#tick(now));
  }

  stop(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
  }

  #tick(now: number): void {
    const { scene } = this.#session;
    this.#frame = 0;
    // A long rest is no time for the camera's motion.
    const seconds = Math.min(0.1, (now - this.#last) / 1000);
    this.#last = now;
    const moving = scene?.rig.update(seconds) ?? false;
    if (this.#stale && this.#due) this.#sync();
    if (!this.#exact(moving) && !this.#live()) scene?.render();
    this.#drawn();
    if (moving || this.#stale) this.wake();
  }

  #sync(): void {
    const session = this.#session;
    this.#stale = false;
    this.#synced = performance.now();
    const items = this.#solids(session.shown()).map(({ solid, preview }) => ({ ...solid, preview }));
    if (!sameItems(items, this.#items)) this.version++;
    // numbers that tick while somebody draws would be in the way
    if (!session.state.wet)
      this.triangles = items.reduce((sum, { mesh }) => sum + mesh.indices.length / 3, 0);
    this.#items = items;
    session.scene?.sync(items);
    session.scene?.guide(session.volumes ? guidesOf(session.shown()) : null);
    // Fitting needs the size of the picture as well as the parts.
    if (this.fit && session.scene && session.size.width > 1 && session.bodies.drafted) this.#showAll();
  }

  /** Drafts may lack what is thin: when it is there all is fitted once more, unless somebody looks elsewhere by then. */
  #showAll(): void {
    const session = this.#session;
    const isElsewhere =
      this.#fitted !== null && JSON.stringify(this.#fitted) !== JSON.stringify(session.view);
    if (!isElsewhere) session.camera.showAll(false);
    this.fit = !isElsewhere && session.bodies.lacking;
    if (this.fit) this.#fitted = session.view;
  }

  /** Whether the surface itself is seen, and all is drawn. */
  #exact(moving: boolean): boolean {
    const { scene, exact, look, view, bodies } = this.#session;
    if (!scene || look.mode !== 'exact' || moving || this.#stale || bodies.making) {
      exact.rest();
      return false;
    }
    if (look !== this.#look) this.version++;
    this.#look = look;
    return exact.frame({ scene, bodies: shownBodies(this.#session.shown()), view, version: this.version });
  }

  /** Whether what moves is drawn by rays. */
  #live(): boolean {
    const { scene, exact, look, view } = this.#session;
    if (!scene || look.mode !== 'exact') return false;
    return exact.live({ scene, bodies: shownBodies(this.#session.shown()), view });
  }

  /** A preview that took long waits its turn: the pen has the time before it. */
  get #due(): boolean {
    if (!this.#session.state.wet || this.buildTime < SLOW_PREVIEW) return true;
    return performance.now() - this.#synced > 4 * this.buildTime;
  }

  #solids(shown: Document): Shown[] {
    const start = performance.now();
    const found = this.#build(shown);
    const took = performance.now() - start;
    // Less is a look into the cache.
    if (took > 0.5) this.buildTime = took;
    return found;
  }

  #build(shown: Document): Shown[] {
    const session = this.#session;
    try {
      // first, so that what was there stands in for what is not made yet
      session.bodyWork.wantShown();
      const kept = solids(shown).map((solid) => ({ solid, preview: false }));
      const draft = draftSolids(shown).map((solid) => ({ solid, preview: true }));
      // What encloses nothing is no mesh to draw.
      return [...kept, ...draft].filter(({ solid }) => solid.mesh.indices.length > 0);
    } catch (error) {
      // A surface that cannot be built must not take the drawing with it.
      console.error(error);
      session.said = WORDS.failed;
      return solids(session.document).map((solid) => ({ solid, preview: false }));
    }
  }
}

const sameItems = (a: readonly SceneItem[], b: readonly SceneItem[]): boolean =>
  a.length === b.length &&
  a.every(({ id, mesh, colour, finish, preview }, i) => {
    const other = b[i]!;
    const isLit = other.colour === colour && other.finish === finish;
    return isLit && other.id === id && other.mesh === mesh && other.preview === preview;
  });
