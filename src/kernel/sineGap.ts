/** What powers of a sine leave of an angle, from their series, because the difference itself cancels. Angles of 0…π/4: 1e-16. */

/** θ − sin θ, which is 2 ∫ sin² from −θ/2 to θ/2 */
export function sineGap(theta: number): number {
  const q = theta * theta;
  const low = 0.16666666666666666 - q * (0.008333333333333333 - q * 0.0001984126984126984);
  const high =
    2.7557319223985893e-6 -
    q *
      (2.505210838544172e-8 -
        q * (1.6059043836821613e-10 - q * (7.647163731819816e-13 - q * 2.8114572543455206e-15)));
  return theta * q * (low - q * q * q * high);
}

/** 3θ/8 − sin θ/2 + sin 2θ/16, which is ∫ sin⁴ from −θ/2 to θ/2 */
export function sineGap4(theta: number): number {
  const q = theta * theta;
  const low = 0.0125 - q * (0.001488095238095238 - q * (8.680555555555556e-5 - q * 3.1941438191438193e-6));
  const high =
    8.214200922534256e-8 -
    q *
      (1.5657567740901075e-9 -
        q * (2.3030052098971334e-11 - q * (2.6936966544376273e-13 - q * 2.5654547445902876e-15)));
  return theta * q * q * (low + q * q * q * q * high);
}
