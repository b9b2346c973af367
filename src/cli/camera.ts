/** `--camera`: a side of the model, or the angles it is looked at from. */
import type { Shot } from '../element/shot.ts';
import { Problem } from './problem.ts';

type Camera = NonNullable<Shot['camera']>;
type Side = Extract<Camera, string>;

const SIDES: readonly Side[] = ['front', 'back', 'left', 'right', 'top', 'bottom'];
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)$/;

export function camera(text: string | undefined): Camera | undefined {
  if (text === undefined) return undefined;
  const side = SIDES.find((name) => name === text);
  if (side) return side;
  const words = text.split(',');
  const [yaw, pitch, roll = 0] = words.map((word) => (NUMBER.test(word) ? Number(word) : Number.NaN));
  const known = [yaw, pitch, roll].every((degrees) => Math.abs(degrees ?? Number.NaN) <= MOST);
  if (known && words.length >= 2 && words.length <= 3) return { yaw: yaw!, pitch: pitch!, roll };
  const expected = `${SIDES.join(', ')} or yaw,pitch[,roll] in degrees, as in 30,20`;
  throw new Problem(`--camera: expected ${expected}; found '${text}'`);
}

/** degrees; ten turns are meant, more are a slip */
const MOST = 3600;
