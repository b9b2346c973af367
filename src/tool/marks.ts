/**
 * What the blue pencil draws for a tool: guides, lit outlines, centre lines, in the model's own space, so that they stay where they
 * belong while the view turns. How they look is the overlay's (element/marks.ts); words are the interface's.
 */
import type { Vec3 } from '../math/vec.ts';

/**
 * `flat`: blue, the chord of a section; `full` and `hollow`: its round sides, ink, solid and dashed; `lit`: broad and blue, what would be
 * drawn over; `axis`: blue dashes; `control`: thin, of nets.
 */
export type LineStyle = 'flat' | 'full' | 'hollow' | 'lit' | 'axis' | 'control';

/** What labels can say. */
export type MarkWord = 'full' | 'flat' | 'hollow' | 'front' | 'back';

export type Mark =
  | {
      readonly kind: 'line';
      readonly style: LineStyle;
      /** mm, in the world, as all points here */
      readonly points: readonly Vec3[];
      readonly closed?: true;
    }
  /** a place where ends snap; `held`: one does */
  | { readonly kind: 'dot'; readonly at: Vec3; readonly held?: true }
  /** of a net: small */
  | { readonly kind: 'knot'; readonly at: Vec3 }
  /** dashed, round the place that the pen is near */
  | { readonly kind: 'ring'; readonly at: Vec3 }
  /** on its outer side, as seen from `from` */
  | { readonly kind: 'label'; readonly at: Vec3; readonly from: Vec3; readonly word: MarkWord }
  /** a value on blue, outside `at` as seen from `from` */
  | {
      readonly kind: 'tag';
      readonly at: Vec3;
      readonly from: Vec3;
      readonly value: number;
      readonly unit: '%' | '°' | 'mm';
    };
