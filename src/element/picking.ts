/** What is under a place of the picture. On bodies it is their surface itself, whatever is seen of them: strokes that start there stay, meshes do not. */
import { bodyMade } from '../document/bodies.ts';
import { isImplicit } from '../document/document.ts';
import { partsWithDraft } from '../document/draftPart.ts';
import { bodiesOf, type NamedNode } from '../document/fieldParts.ts';
import { nodeOf } from '../document/solidNode.ts';
import { rayAt } from '../stroke/plane.ts';
import { isCastable, pickedAmong, pickedOn } from './exactPick.ts';
import type { Picked } from './picked.ts';
import type { Session } from './session.ts';

/** `x`, `y`: CSS pixels; `except` are ids that it looks through. */
export function pickAt(
  { scene, document, look, view, size }: Pick<Session, 'scene' | 'document' | 'look' | 'view' | 'size'>,
  x: number,
  y: number,
  except: readonly string[],
): Picked | null {
  if (!scene) return null;
  const isSeen = ({ id, hidden }: NamedNode) => !hidden && !except.includes(id);
  const bodies = look.mode === 'exact' ? bodiesOf(document).filter(isSeen).filter(isCastable) : [];
  const hit = scene.pick(x, y, [...except, ...bodies.map(({ id }) => id)]);
  if (bodies.length > 0) return pickedAmong(bodies, hit, { view, ...size, offset: [0, 0] }, [x, y]);
  if (!hit) return null;
  const part = partsWithDraft(document)
    .filter(isImplicit)
    .find(({ id }) => id === hit.id);
  const made = part && bodyMade(nodeOf(part));
  return made ? pickedOn(hit, part, rayAt(view, size, x, y), made) : { ...hit, skel: null };
}
