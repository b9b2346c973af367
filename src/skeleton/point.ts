/**
 * A point with a weight: w f(r).
 *
 * Kernels without a width count in the radius at which a lone point has the value 1, so that coordinates stay near 1.
 */
import type { Kernel, KernelParams } from '../kernel/kernel.ts';
import { pow } from '../math/pow.ts';
import { checkedParams, checkNumbers, checkPlaces, reach, whole } from './binding.ts';
import type { See } from './sight.ts';
import type { FieldValue, Skeleton, SkelField } from './skeleton.ts';
import type { PointSkel } from './skels.ts';
import { Spreader } from './spread.ts';
import { addSource } from './taylor.ts';

export const point: Skeleton<PointSkel> = { name: 'point', bind };

function bind({ at, weight }: PointSkel, kernel: Kernel, params: KernelParams): SkelField {
  const checked = checkedParams(kernel, params);
  checkPlaces('the coordinates of a point', at);
  checkNumbers('the weight of a point', [weight]);
  const { homogeneity, support } = kernel;
  const size = homogeneity === 0 || weight === 0 ? 1 : pow(Math.abs(weight), -1 / homogeneity);
  const unit = kernel.unit(checked, size);
  const exponent = checked.n ?? 4;
  const factor = weight * whole(unit, homogeneity);
  const [ax, ay, az] = at;
  const per = 1 / unit;
  const least = kernel.floor2.line;
  const { change } = kernel;
  const [core, n] = change.type === 'relative' ? [change.core, change.power(exponent)] : [1, exponent];
  const extent = {
    dimension: 0,
    size: 1,
    turns: 1,
    most: Math.abs(factor),
    sign: Math.sign(factor),
    evenness: 1,
  } as const;
  const squared = (x: number, y: number, z: number): number => {
    const dx = (x - ax) * per;
    const dy = (y - ay) * per;
    const dz = (z - az) * per;
    return Math.max(dx * dx + dy * dy + dz * dz, least);
  };
  const see: See = ({ x, y, z }, sight) => {
    sight.distance = Math.sqrt(squared(x, y, z));
    sight.isClear = true;
    sight.slack = 0;
  };
  const spreader = new Spreader(kernel, exponent, extent, per, see, {
    choose(choice) {
      choice.count = 1;
      choice.off = 0;
    },
    add({ x, y, z }, scale, _, out) {
      const r2 = squared(x, y, z);
      const value = scale * factor * kernel.value(r2, exponent);
      const q = 1 / (core + r2);
      const first = -0.5 * n * q * value * per * per;
      addSource(out, value, first, -(0.5 * n + 1) * q * first * per * per, x - ax, y - ay, z - az);
    },
  });
  const field: SkelField = {
    box: { min: at, max: at },
    offset: (threshold) => (weight === 0 ? 0 : unit * reach((r2) => spreader.most(r2), threshold, support)),
    value: (x, y, z) => factor * kernel.value(squared(x, y, z), exponent),
    add(x: number, y: number, z: number, scale: number, out: FieldValue): void {
      const r2 = squared(x, y, z);
      const steep = 2 * scale * factor * kernel.slope(r2, exponent) * per * per;
      out[0] = out[0]! + scale * factor * kernel.value(r2, exponent);
      out[1] = out[1]! + steep * (x - ax);
      out[2] = out[2]! + steep * (y - ay);
      out[3] = out[3]! + steep * (z - az);
    },
    spread(ball, scale, out) {
      spreader.add(field, ball, scale, out);
    },
    missed: (ball, most) => spreader.missed(ball, most),
    isCubic: change.type === 'relative',
    ahead: (ball, scale, out) => spreader.ahead(field, ball, scale, out),
    apart: () => Infinity,
    standIn: (ball, scale, out) => spreader.standIn(field, ball, scale, out),
  };
  return field;
}
