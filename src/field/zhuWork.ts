/** What a page and the worker that compares Zhu et al.'s rays with ours say to each other. */
import type { Placement } from '../math/placement.ts';
import type { FieldNode } from './node.ts';
import type { RayCamera } from './rayImage.ts';
import type { Compared } from './zhuImage.ts';

/** A body in the picture. */
interface ComparedBody {
  readonly node: FieldNode;
  readonly placement: Placement;
  /** of our lattice, along its longest side */
  readonly cells: number;
}

export interface ToZhu {
  readonly bodies: readonly ComparedBody[];
  /** through the middle of the pixels */
  readonly camera: RayCamera;
}

/** 0–1 of it is done. */
interface Progress {
  readonly type: 'progress';
  readonly share: number;
}

interface Done extends Compared {
  readonly type: 'compared';
  /** of both */
  readonly milliseconds: number;
}

interface Refused {
  readonly type: 'refused';
  readonly message: string;
}

export type FromZhu = Progress | Done | Refused;
