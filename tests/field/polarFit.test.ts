/** Drawn loops become profiles: errors beside those measured before (root mean square and largest, of R, area π). */
import { describe, expect, test } from 'vitest';
import { fitPolarProfile, profileArea } from '../../src/field/polarFit.ts';
import { LEAST_RADIUS, polarProfile } from '../../src/field/polarProfile.ts';
import { pow } from '../../src/math/pow.ts';
import { cos, PI, sin, TAU } from '../../src/math/trig.ts';
import type { Vec2 } from '../../src/math/vec.ts';

/** A loop of radius R(θ) about (x, y). */
function loopOf(radius: (theta: number) => number, x = 0, y = 0, count = 720): Vec2[] {
  return Array.from({ length: count }, (_, i) => {
    const theta = (i * TAU) / count;
    return [x + radius(theta) * cos(theta), y + radius(theta) * sin(theta)];
  });
}

/** The profile's radius at θ against the drawn one's, both scaled to area π. */
function errors(radius: (theta: number) => number): { mean: number; largest: number } {
  const section = polarProfile(fitPolarProfile(loopOf(radius)).profile);
  const thetas = Array.from({ length: 1440 }, (_, i) => ((i + 0.5) * TAU) / 1440);
  const area = thetas.reduce((sum, theta) => sum + (radius(theta) * radius(theta) * TAU) / 2880, 0);
  const size = Math.sqrt(area / PI);
  const off = thetas.map((theta) =>
    Math.abs(1 / section.value(cos(theta), sin(theta)) - radius(theta) / size),
  );
  return { mean: Math.sqrt(off.reduce((sum, e) => sum + e * e, 0) / off.length), largest: Math.max(...off) };
}

const ellipse = (theta: number) => 1 / Math.sqrt(cos(theta) * cos(theta) + 4 * sin(theta) * sin(theta));
const squircle = (theta: number) => pow(pow(Math.abs(cos(theta)), 4) + pow(Math.abs(sin(theta)), 4), -1 / 4);
const star = (theta: number) => 1 + 0.35 * cos(5 * theta);
const square = (theta: number) => 1 / Math.max(Math.abs(cos(theta)), Math.abs(sin(theta)));

describe('fitted profiles', () => {
  test.each([
    ['ellipse 2 : 1', ellipse, 0.002],
    ['squircle', squircle, 0.006],
    ['five-pointed star', star, 0.01],
    ['square', square, 0.11],
  ])('%s', (_, radius, limit) => {
    expect(errors(radius).largest).toBeLessThan(limit);
  });

  test('a circle, wherever it was drawn, is a circle of radius 1', () => {
    const { profile, isStar, centre } = fitPolarProfile(loopOf(() => 7, 20, -3));
    for (const radius of profile.radii) expect(radius).toBeCloseTo(1, 4);
    expect(isStar).toBe(true);
    expect(centre.at[0]).toBeCloseTo(20, 10);
  });

  test('the area is π, whatever the drawn size; orientation does not matter', () => {
    for (const size of [0.01, 1, 500]) {
      const loop = loopOf((theta) => size * star(theta));
      const { profile } = fitPolarProfile(loop);
      expect(profileArea(profile.radii)).toBeCloseTo(PI, 12);
      const turned = fitPolarProfile([...loop].reverse()).profile;
      turned.radii.forEach((radius, i) => {
        expect(radius).toBeCloseTo(profile.radii[i]!, 9);
      });
    }
  });

  test('the area is what quadrature says', () => {
    const radii = Array.from({ length: 24 }, (_, i) => 1 + 0.4 * sin(i * i));
    const section = polarProfile({ type: 'polar', radii });
    let sum = 0;
    for (let i = 0; i < 3600; i++) {
      const theta = ((i + 0.5) * TAU) / 3600;
      const radius = 1 / section.value(cos(theta), sin(theta));
      sum += (0.5 * radius * radius * TAU) / 3600;
    }
    expect(profileArea(radii)).toBeCloseTo(sum, 6);
  });

  test('a loop that hides from every point still makes a usable profile, and says so', () => {
    const horseshoe: Vec2[] = [
      [0, 0],
      [6, 0],
      [6, 6],
      [5, 6],
      [5, 1],
      [1, 1],
      [1, 6],
      [0, 6],
    ];
    const { profile, isStar } = fitPolarProfile(horseshoe);
    expect(isStar).toBe(false);
    expect(Math.min(...profile.radii)).toBeGreaterThanOrEqual(LEAST_RADIUS);
    expect(() => polarProfile(profile)).not.toThrow();
  });
});
