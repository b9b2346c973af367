/**
 * What bounds of fields are asked of. Handed on as one object: numbers that go through calls which the engine does not inline are boxed
 * each time, which took as long as the bounds themselves. Mutable: filled again for each; the numbers say that these are doubles.
 */
export class Ball {
  /** the centre and the radius, mm */
  x = 0.5;
  y = 0.5;
  z = 0.5;
  radius = 0.5;

  set(x: number, y: number, z: number, radius: number): this {
    this.x = x;
    this.y = y;
    this.z = z;
    this.radius = radius;
    return this;
  }
}
