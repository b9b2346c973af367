/** What a page and the worker that compares Zhu et al.'s rays with ours say to each other. */
import type { ExactBody } from './exactWork.ts';
import type { RayCamera } from './rayImage.ts';
import type { Compared } from './zhuImage.ts';

export interface ToZhu {
  readonly bodies: readonly Omit<ExactBody, 'key'>[];
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
